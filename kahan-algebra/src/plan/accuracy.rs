//! What a step keeps of its digits when the time step is long, beside elimination with pivoting.
//!
//! Minors are made of values whose leading terms cancel, which the polynomial that they are does not have; and where a pivot of 1
//! stands beside entries of the size ‖εf′‖, errors grow by that factor. Neither shows while ‖εf′‖ ≤ 1, either can take every digit far
//! beyond, and no rule about degrees tells good forms from bad ones. So it is measured: a form is run, as it would be, at seeded points
//! with ‖εf′‖∞ near 1, 10, 100 and 1000, in floats of 30 bits, and so is elimination with partial pivoting of A d = f, x̃ = x + 2εd.
//! Elimination in 53 bits is the truth for both, as it errs 2⁻²³ times as much as in 30. To first order the rounding errors of a
//! computation are proportional to u, so an error of k u in 30 bits is one of about k u in 53.
//!
//! Medians of a few points are uncertain by a factor of two, so the limits below leave room between them.

mod program;
mod trial;

use std::cell::OnceCell;

use crate::field::Field;
use crate::prime_field::SplitMix64;

use super::StepPlan;
use program::{Program, short};
use trial::{Elimination, Trial};

/// The largest ‖εf′‖∞ that is looked at,
pub const LARGEST_SIZE: u32 = 1000;
/// and all of them.
const SIZES: [u32; 4] = [1, 10, 100, LARGEST_SIZE];
/// The points of each size at first,
const FEW: usize = 25;
/// and where these leave a doubt.
const MANY: usize = 100;
/// How much more than the median the tail may lose.
const TAIL_FACTOR: f64 = 3.0;
/// A median error of elimination below this counts as this, in units u,
const SMALL: f64 = 10.0;
/// and a tail below this is good whatever elimination does.
const SMALL_TAIL: f64 = 1000.0;

/// A form that errs more than elimination by a larger factor than this is refused, if there is one
const REFUSED: f64 = 45.0;
/// that does so by at most this.
const CLOSE: f64 = 5.0;
/// Up to this factor a form is said to hold. Between this and what is refused it is kept, and says how far it holds.
const HOLDS: f64 = 8.0;
/// From what holds to here a few points leave a doubt.
const DOUBTFUL: f64 = 3.0 * REFUSED;

/// Points of every size, and what elimination makes of them.
pub(super) struct Accuracy<'a> {
    field: &'a Field,
    few: Vec<Vec<Trial>>,
    many: OnceCell<Vec<Vec<Trial>>>,
}

/// By what factor a step errs more than elimination, size by size.
#[derive(Debug)]
pub(super) struct Loss(Vec<f64>);

impl<'a> Accuracy<'a> {
    pub(super) fn of(field: &'a Field) -> Self {
        Accuracy { field, few: points(field, FEW), many: OnceCell::new() }
    }

    /// How much more a step errs than elimination.
    pub(super) fn loss(&self, step: &StepPlan) -> Loss {
        let runner = Runner::of(step);
        let loss = |points: &[Vec<Trial>]| Loss(points.iter().map(|trials| runner.loss(trials)).collect());
        let first = loss(&self.few);
        if first.is_doubtful() { loss(self.many.get_or_init(|| points(self.field, MANY))) } else { first }
    }

    /// Whether a step errs hardly more at any size; the largest one, which decides nearly always, comes first.
    pub(super) fn is_close(&self, step: &StepPlan) -> bool {
        let runner = Runner::of(step);
        self.few.iter().rev().all(|trials| runner.loss(trials) <= CLOSE)
    }
}

/// So many points of each size. Where f′ vanishes there are none; a field of which that is mostly so has nothing to lose.
fn points(field: &Field, count: usize) -> Vec<Vec<Trial>> {
    let elimination = Elimination::of(field);
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
        self.0.iter().any(|loss| *loss > REFUSED)
    }

    /// Whether more points may say something else.
    fn is_doubtful(&self) -> bool {
        let largest = self.0.iter().copied().fold(0.0, f64::max);
        (HOLDS..DOUBTFUL).contains(&largest)
    }

    /// The largest size up to which the step holds; 0 if there is none.
    pub(super) fn holds_to(&self) -> u32 {
        let held = SIZES.iter().zip(&self.0).take_while(|(_, loss)| **loss <= HOLDS);
        held.last().map_or(0, |(size, _)| *size)
    }
}

/// A step made ready to be run in short floats.
struct Runner<'a> {
    step: &'a StepPlan,
    constants: Program<'a>,
    kernel: Program<'a>,
}

impl<'a> Runner<'a> {
    fn of(step: &'a StepPlan) -> Self {
        Runner { step, constants: Program::of(&step.constants), kernel: Program::of(&step.kernel) }
    }

    /// The ratio of the medians or, where that is larger, a part of the ratio of the tails.
    fn loss(&self, trials: &[Trial]) -> f64 {
        if trials.len() < FEW {
            return 0.0;
        }
        let [median, tail] = quantiles(trials.iter().map(|trial| self.error(trial)).collect());
        let [its_median, its_tail] = quantiles(trials.iter().map(|trial| trial.elimination).collect());
        let of_tails = if tail <= SMALL_TAIL { 0.0 } else { tail / (TAIL_FACTOR * its_tail.max(SMALL)) };
        of_tails.max(median / its_median.max(SMALL))
    }

    /// The error of one step.
    fn error(&self, trial: &Trial) -> f64 {
        let n = self.step.reciprocals.len();
        let constants = self.constants.run(short, &trial.inputs, &[]);
        let results = self.kernel.run(short, &trial.inputs, &constants);
        let mut next = Vec::with_capacity(n);
        for (i, place) in self.step.reciprocals.iter().enumerate() {
            let increment = place.map_or(results[i], |place| short(results[i] * results[n + place]));
            next.push(short(trial.inputs[i] + increment));
        }
        trial.error(&next)
    }
}

/// The median, and what stands for the tail: what eight of a hundred exceed.
fn quantiles(mut errors: Vec<f64>) -> [f64; 2] {
    errors.sort_by(f64::total_cmp);
    [errors[errors.len() / 2], errors[errors.len() - 1 - errors.len() * 2 / FEW]]
}
