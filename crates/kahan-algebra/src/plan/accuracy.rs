//! Measures how many digits a step loses in long time steps, compared with elimination with
//! pivoting.
//!
//! Digits are lost if leading terms of minors cancel, or if a step eliminates with the pivot 1 in a
//! matrix with large entries. The preferred formulas for a step run in floats of 30 bits, at seeded
//! points with ‖εf′‖∞ near 1, 10, 100 and 1000. Elimination with pivoting also runs in 30 bits, and
//! in 53 bits as reference. Errors are multiples of the unit roundoff u. A formula is replaced if
//! its errors exceed a fixed multiple of those of elimination, and a better formula exists.

mod float_plan;
mod sample_step;

use std::cell::OnceCell;

use kahan_syntax::table::sorted_by;

use crate::field::Field;
use crate::prime_field::SplitMix64;

use super::{LARGEST_SIZE, Plan, StepPlan};
use float_plan::{FloatPlan, short};
use sample_step::{Elimination, SampleStep};

/// Points are drawn at these sizes ‖εf′‖∞.
const STEP_SIZES: [u32; 4] = [1, 10, 100, LARGEST_SIZE];
/// The number of points of each size in the first round.
const FIRST_ROUND_POINTS: usize = 25;
/// The number of points of each size in the second round.
const SECOND_ROUND_POINTS: usize = 100;
/// A step's median error may be at most this multiple of that of elimination.
const MEDIAN_FACTOR: f64 = 30.0;
/// A smaller median error of elimination is replaced by this multiple of the unit roundoff.
const LEAST_MEDIAN_ERROR: f64 = 10.0;
/// At the quantile `TAIL_QUANTILE`, a step's error may be at most this multiple of elimination's.
const TAIL_FACTOR: f64 = 60.0;
/// Errors up to this multiple of the unit roundoff are accepted at the quantile `TAIL_QUANTILE`.
const LEAST_TAIL_ERROR: f64 = 1000.0;
/// A step is refused if its errors exceed their limits by this factor and a replacement exists.
const REFUSAL_RATIO: f64 = 1.5;
/// A step can replace a refused step if its errors are at most this fraction of their limits.
const REPLACEMENT_RATIO: f64 = 1.0 / 6.0;
/// A second round is skipped if the errors are probably below this fraction of their limits.
const CLEARLY_WITHIN_RATIO: f64 = 0.2;
/// A second round is skipped if the errors of the first round exceed their limits by this factor.
const CLEARLY_BEYOND_RATIO: f64 = 3.0 * REFUSAL_RATIO;
/// With probability 0.9, the median of the distribution is between the quantiles ½ ±
/// MEDIAN_BAND_FACTOR/√n of n measured errors.
const MEDIAN_BAND_FACTOR: f64 = 0.8;
/// A step is called accurate if its errors are at most this fraction of their limits.
const CLAIMED_RATIO: f64 = 0.6;
/// The quantile that stands for the large errors of a step.
const TAIL_QUANTILE: f64 = 0.9;

/// The sample points of every size, with the errors of elimination.
pub(super) struct Accuracy<'a> {
    field: &'a Field,
    few: Vec<Vec<SampleStep>>,
    many: OnceCell<Vec<Vec<SampleStep>>>,
}

/// The ratio of a step's errors to their limit, for each size ‖εf′‖∞ in `STEP_SIZES`.
#[derive(Debug)]
pub(super) struct AccuracyLoss(Vec<Ratio>);

/// The measured ratio of errors to their limit, and an upper confidence bound of this ratio.
#[derive(Clone, Copy, Debug)]
struct Ratio {
    measured: f64,
    largest: f64,
}

impl<'a> Accuracy<'a> {
    pub(super) fn of(field: &'a Field) -> Self {
        Accuracy { field, few: sample_steps(field, FIRST_ROUND_POINTS), many: OnceCell::new() }
    }

    /// Measures the errors of a step, in two rounds if needed.
    pub(super) fn loss(&self, step: &StepPlan) -> AccuracyLoss {
        let runner = Runner::of(step);
        let loss = |points: &[Vec<SampleStep>]| {
            AccuracyLoss(points.iter().map(|trials| runner.loss(trials)).collect())
        };
        let first = loss(&self.few);
        if first.is_doubtful() {
            loss(self.many.get_or_init(|| sample_steps(self.field, SECOND_ROUND_POINTS)))
        } else {
            first
        }
    }

    pub(super) fn is_kept(&self, step: &StepPlan) -> bool {
        let runner = Runner::of(step);
        self.few.iter().rev().all(|trials| runner.loss(trials).measured <= REPLACEMENT_RATIO)
    }

    /// Returns whether `carry`, a plan that maps x, v and x̃ to the image of a tangent vector v, is
    /// accurate enough. The sample points must be those of the variational field.
    pub(super) fn keeps_tangents(&self, carry: &Plan) -> bool {
        let program = FloatPlan::of(carry);
        let n = carry.outputs.len();
        let error = |trial: &SampleStep| {
            let inputs: Vec<f64> = trial.inputs.iter().chain(&trial.next[..n]).copied().collect();
            trial.error_from(n, &program.run(short, &inputs, &[]))
        };
        self.few.iter().all(|trials| ratio(trials, error).measured <= REFUSAL_RATIO)
    }
}

fn sample_steps(field: &Field, count: usize) -> Vec<Vec<SampleStep>> {
    let plan = Elimination::plan(field);
    let elimination = Elimination::of(field, &plan);
    let mut random = SplitMix64::from_bytes(b"long steps");
    let mut of_size = |size: u32| {
        let drawn =
            (0..2 * count).filter_map(|_| SampleStep::draw(&elimination, f64::from(size), &mut random));
        drawn.take(count).collect()
    };
    STEP_SIZES.into_iter().map(&mut of_size).collect()
}

impl AccuracyLoss {
    /// Returns whether errors are so large that a more accurate step is preferred.
    pub(super) fn is_refused(&self) -> bool {
        self.worst() > REFUSAL_RATIO
    }

    fn is_doubtful(&self) -> bool {
        let largest = self.0.iter().map(|ratio| ratio.largest).fold(0.0, f64::max);
        largest > CLEARLY_WITHIN_RATIO && self.worst() < CLEARLY_BEYOND_RATIO
    }

    fn worst(&self) -> f64 {
        self.0.iter().map(|ratio| ratio.measured).fold(0.0, f64::max)
    }

    /// Returns the largest tested size ‖εf′‖∞ up to which the step is accurate; 0 if the step is
    /// inaccurate at the smallest tested size.
    pub(super) fn holds_to(&self) -> u32 {
        let held = STEP_SIZES.iter().zip(&self.0).take_while(|(_, ratio)| ratio.largest <= CLAIMED_RATIO);
        held.last().map_or(0, |(size, _)| *size)
    }
}

struct Runner<'a> {
    step: &'a StepPlan,
    constants: FloatPlan<'a>,
    kernel: FloatPlan<'a>,
}

impl<'a> Runner<'a> {
    fn of(step: &'a StepPlan) -> Self {
        Runner { step, constants: FloatPlan::of(&step.constants), kernel: FloatPlan::of(&step.kernel.plan) }
    }

    fn loss(&self, trials: &[SampleStep]) -> Ratio {
        ratio(trials, |trial| self.error(trial))
    }

    fn error(&self, trial: &SampleStep) -> f64 {
        let constants = self.constants.run(short, &trial.inputs, &[]);
        let results = self.kernel.run(short, &trial.inputs, &constants);
        let next = trial.inputs.iter().zip(self.step.kernel.factors(&results)).map(|(x, (numerator, by))| {
            let increment = by.map_or(*numerator, |reciprocal| short(numerator * reciprocal));
            short(x + increment)
        });
        trial.error_from(0, &next.collect::<Vec<_>>())
    }
}

/// Returns the ratio of errors to their limit at the median or at [`TAIL_QUANTILE`], whichever
/// ratio is larger.
fn ratio(trials: &[SampleStep], error: impl Fn(&SampleStep) -> f64) -> Ratio {
    if trials.len() < FIRST_ROUND_POINTS {
        return Ratio { measured: 0.0, largest: 0.0 };
    }
    let own = sorted_by(trials.iter().map(error), f64::total_cmp);
    let others = sorted_by(trials.iter().map(|trial| trial.elimination), f64::total_cmp);
    let band = MEDIAN_BAND_FACTOR / (trials.len() as f64).sqrt();
    // A positive `shift` raises the quantile of the step and lowers that of elimination.
    let ratio = |shift: f64| {
        let of_medians = quantile(&own, 0.5 + shift)
            / (MEDIAN_FACTOR * quantile(&others, 0.5 - shift).max(LEAST_MEDIAN_ERROR));
        let tail = quantile(&own, TAIL_QUANTILE + shift / 2.0);
        let of_tails = tail / (TAIL_FACTOR * quantile(&others, TAIL_QUANTILE - shift / 2.0));
        if tail <= LEAST_TAIL_ERROR { of_medians } else { of_medians.max(of_tails) }
    };
    Ratio { measured: ratio(0.0), largest: ratio(band) }
}

fn quantile(sorted: &[f64], share: f64) -> f64 {
    let last = (sorted.len() - 1) as f64;
    sorted[(last * share).round() as usize]
}
