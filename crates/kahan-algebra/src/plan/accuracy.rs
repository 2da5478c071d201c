//! What a step keeps of its digits when the time step is long, beside elimination with pivoting.
//!
//! Minors are made of values whose leading terms cancel, which the polynomial that they are does
//! not have; and where a pivot of 1 stands beside entries of the size ‖εf′‖, errors grow by that
//! factor. Neither shows while ‖εf′‖ ≤ 1, either can take every digit far beyond, and no rule about
//! degrees tells good forms from bad ones. So it is measured: a form is run, as it would be, at
//! seeded points with ‖εf′‖∞ near 1, 10, 100 and 1000, in floats of 30 bits, and so is elimination
//! with partial pivoting of A d = f, x̃ = x + 2εd. Elimination in 53 bits is the truth for both, as
//! it errs 2⁻²³ times as much as in 30. To first order the rounding errors of a computation are
//! proportional to u, so an error of k u in 30 bits is one of about k u in 53.
//!
//! A form whose errors are beyond the limits is refused if another form stays well within them.
//! Every form says up to which size its errors are certain to be within the limits.

mod float_plan;
mod trial;

use std::cell::OnceCell;

use kahan_syntax::table::sorted_by;

use crate::field::Field;
use crate::prime_field::SplitMix64;

use super::{LARGEST_SIZE, Plan, StepPlan};
use float_plan::{FloatPlan, short};
use trial::{Elimination, Trial};

/// All sizes ‖εf′‖∞ that are looked at.
const SIZES: [u32; 4] = [1, 10, 100, LARGEST_SIZE];
/// The points of each size at first.
const FEW: usize = 25;
/// The points of each size where the first leave a doubt.
const MANY: usize = 100;
/// By what factor a step's median error may be larger than that of elimination.
const MEDIAN_FACTOR: f64 = 30.0;
/// A median error of elimination below this many units u counts as this many.
const SMALL: f64 = 10.0;
/// By what factor the tail of a step's errors may be larger than that of elimination.
const TAIL_FACTOR: f64 = 60.0;
/// A tail below this many units u is never too large.
const SMALL_TAIL: f64 = 1000.0;
/// A step that exceeds the limits by this factor is refused where another one is kept.
const REFUSED: f64 = 1.5;
/// A step whose errors are at most this part of the limits may stand in for one that is refused.
const KEPT: f64 = 1.0 / 6.0;
/// Below this part of the limits a few points leave no doubt.
const CLEAR: f64 = 0.2;
/// Above this part of the limits a few points leave no doubt either.
const DOUBTFUL: f64 = 3.0 * REFUSED;
/// A median of n errors lies within the quantiles ½ ± this/√n, nine times in ten.
const BAND: f64 = 0.8;
/// A step is said to hold where it stays within this part of the limits: other points differ from
/// those that were looked at.
const CLAIMED: f64 = 0.6;
/// The quantile that stands for the tail.
const TAIL: f64 = 0.9;

/// Points of every size, and what elimination makes of them.
pub(super) struct Accuracy<'a> {
    field: &'a Field,
    few: Vec<Vec<Trial>>,
    many: OnceCell<Vec<Vec<Trial>>>,
}

/// What a step loses that elimination keeps, size by size.
#[derive(Debug)]
pub(super) struct Loss(Vec<Ratio>);

/// Errors over what they may be, 1 at the limit.
#[derive(Clone, Copy, Debug)]
struct Ratio {
    /// As measured.
    measured: f64,
    /// The largest that the points leave room for.
    largest: f64,
}

impl<'a> Accuracy<'a> {
    pub(super) fn of(field: &'a Field) -> Self {
        Accuracy { field, few: points(field, FEW), many: OnceCell::new() }
    }

    /// What a step loses; where the points leave a doubt, there are more.
    pub(super) fn loss(&self, step: &StepPlan) -> Loss {
        let runner = Runner::of(step);
        let loss = |points: &[Vec<Trial>]| Loss(points.iter().map(|trials| runner.loss(trials)).collect());
        let first = loss(&self.few);
        if first.is_doubtful() { loss(self.many.get_or_init(|| points(self.field, MANY))) } else { first }
    }

    /// Whether a step stays well within the limits at every size; the largest one, which decides
    /// nearly always, comes first.
    pub(super) fn is_kept(&self, step: &StepPlan) -> bool {
        let runner = Runner::of(step);
        self.few.iter().rev().all(|trials| runner.loss(trials).measured <= KEPT)
    }

    /// Whether a form that carries tangent vectors from x to x̃ stays within the limits that a step
    /// is refused beyond; this is the variational field.
    pub(super) fn keeps_tangents(&self, carry: &Plan) -> bool {
        let program = FloatPlan::of(carry);
        let n = carry.outputs.len();
        let error = |trial: &Trial| {
            let inputs: Vec<f64> = trial.inputs.iter().chain(&trial.next[..n]).copied().collect();
            trial.error_from(n, &program.run(short, &inputs, &[]))
        };
        self.few.iter().all(|trials| ratio(trials, error).measured <= REFUSED)
    }
}

/// So many points of each size. Where f′ vanishes there are none; a field of which that is mostly
/// so has nothing to lose.
fn points(field: &Field, count: usize) -> Vec<Vec<Trial>> {
    let plan = Elimination::plan(field);
    let elimination = Elimination::of(field, &plan);
    let mut random = SplitMix64::from_bytes(b"long steps");
    let mut of_size = |size: u32| {
        let drawn = (0..2 * count).filter_map(|_| Trial::draw(&elimination, f64::from(size), &mut random));
        drawn.take(count).collect()
    };
    SIZES.into_iter().map(&mut of_size).collect()
}

impl Loss {
    /// Whether a step is refused where there is a better one.
    pub(super) fn is_refused(&self) -> bool {
        self.worst() > REFUSED
    }

    /// Whether more points may say something else.
    fn is_doubtful(&self) -> bool {
        let largest = self.0.iter().map(|ratio| ratio.largest).fold(0.0, f64::max);
        largest > CLEAR && self.worst() < DOUBTFUL
    }

    fn worst(&self) -> f64 {
        self.0.iter().map(|ratio| ratio.measured).fold(0.0, f64::max)
    }

    /// The largest size up to which the step holds for certain; 0 if there is none.
    pub(super) fn holds_to(&self) -> u32 {
        let held = SIZES.iter().zip(&self.0).take_while(|(_, ratio)| ratio.largest <= CLAIMED);
        held.last().map_or(0, |(size, _)| *size)
    }
}

/// A step made ready to be run in short floats.
struct Runner<'a> {
    step: &'a StepPlan,
    constants: FloatPlan<'a>,
    kernel: FloatPlan<'a>,
}

impl<'a> Runner<'a> {
    fn of(step: &'a StepPlan) -> Self {
        Runner { step, constants: FloatPlan::of(&step.constants), kernel: FloatPlan::of(&step.kernel.plan) }
    }

    /// The ratios of its errors to what they may be.
    fn loss(&self, trials: &[Trial]) -> Ratio {
        ratio(trials, |trial| self.error(trial))
    }

    /// The error of one step.
    fn error(&self, trial: &Trial) -> f64 {
        let constants = self.constants.run(short, &trial.inputs, &[]);
        let results = self.kernel.run(short, &trial.inputs, &constants);
        let next = trial.inputs.iter().zip(self.step.kernel.factors(&results)).map(|(x, (numerator, by))| {
            let increment = by.map_or(*numerator, |reciprocal| short(numerator * reciprocal));
            short(x + increment)
        });
        trial.error_from(0, &next.collect::<Vec<_>>())
    }
}

/// The ratios of medians and of tails to what they may be.
fn ratio(trials: &[Trial], error: impl Fn(&Trial) -> f64) -> Ratio {
    if trials.len() < FEW {
        return Ratio { measured: 0.0, largest: 0.0 };
    }
    let own = sorted_by(trials.iter().map(error), f64::total_cmp);
    let others = sorted_by(trials.iter().map(|trial| trial.elimination), f64::total_cmp);
    let band = BAND / (trials.len() as f64).sqrt();
    // The step read off at `shift` from a quantile, elimination as far on the other side.
    let ratio = |shift: f64| {
        let of_medians =
            quantile(&own, 0.5 + shift) / (MEDIAN_FACTOR * quantile(&others, 0.5 - shift).max(SMALL));
        let tail = quantile(&own, TAIL + shift / 2.0);
        let of_tails = tail / (TAIL_FACTOR * quantile(&others, TAIL - shift / 2.0));
        if tail <= SMALL_TAIL { of_medians } else { of_medians.max(of_tails) }
    };
    Ratio { measured: ratio(0.0), largest: ratio(band) }
}

/// The value that this share of sorted values is below.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let last = (sorted.len() - 1) as f64;
    sorted[(last * share).round() as usize]
}
