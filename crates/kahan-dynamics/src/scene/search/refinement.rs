//! Trials of a scheme with larger and larger numbers of steps.
//!
//! The trials stop if one meets the tolerance, or if a further one costs more than a known setting
//! or takes too long. They also stop if the law error ∝ ε^order predicts such a cost, or if two
//! successive trials gain nothing because of rounding errors. A scheme has at most 34 trials.

use kahan_core::Composition;

use super::{
    EQUAL_ERROR_RATIO, PHASE_LOSS_ERROR, PLAIN_DOUBLE, PLAIN_DOUBLE_DOUBLE, Scheme, Search, Setting, Trials,
};

/// Errors follow the law error ∝ ε^order if the logarithm of (previous error)/error differs from
/// the predicted logarithm by less than this fraction.
const ORDER_LAW_TOLERANCE: f64 = 0.3;
/// The error below which the law error ∝ ε^order is trusted.
const ORDER_LAW_ERROR: f64 = 0.01;
/// After this number of successive trials without gain, the search tests whether rounding errors
/// are the reason.
const STALLS_BEFORE_CHECK: u32 = 2;
/// A trial is without gain if the logarithm of its gain is below this fraction of the predicted
/// logarithm.
const STALL_FRACTION: f64 = 0.3;
const RUNGS: usize = 34;
/// The factor by which rounding errors vary between neighbouring values of ε.
const ROUNDING_VARIATION: f64 = 30.0;
/// If errors follow the law error ∝ ε^order, the next trial has at most this many times the steps.
const MAX_STEPS_RATIO: u64 = 1 << 12;

#[derive(Clone, Copy, Debug)]
struct ErrorReduction {
    before: f64,
    /// The previous error divided by the current one.
    factor: f64,
    /// log(`factor`) divided by the logarithm that the law error ∝ ε^order predicts.
    part: f64,
}

impl ErrorReduction {
    /// Returns whether the gain follows the law error ∝ ε^order, at a sufficiently small error.
    fn is_lawful(&self) -> bool {
        (self.part - 1.0).abs() < ORDER_LAW_TOLERANCE && self.before < self.factor * ORDER_LAW_ERROR
    }

    fn of(before: &Setting, now: &Setting) -> Self {
        let factor = before.error / now.error;
        let by_law = (now.steps as f64 / before.steps as f64).powi(now.scheme.order() as i32);
        Self { before: before.error, factor, part: libm::log(factor) / libm::log(by_law) }
    }
}

/// The result of the trials of one scheme.
#[derive(Clone, Copy, Debug, Default)]
pub struct RefinementResult {
    /// Whether some trial followed the law error ∝ ε^order.
    was_lawful: bool,
    /// Whether some trial gained less than the order predicts.
    gained_little: bool,
    stalls: u32,
    has_stalled: bool,
    pub(super) finest: Option<Setting>,
}

impl RefinementResult {
    /// Returns whether errors fell less than the order predicts, perhaps because of rounding
    /// errors.
    #[must_use]
    pub const fn has_felt_roundings(&self) -> bool {
        self.gained_little
    }

    /// Returns whether the trials stopped because of rounding errors.
    #[must_use]
    pub const fn has_stalled(&self) -> bool {
        self.has_stalled
    }

    /// Records a trial. Returns its gain over the previous trial, if that had a finite error.
    fn add(&mut self, trial: Setting) -> Option<ErrorReduction> {
        let before = self.finest.replace(trial).filter(|before| before.error.is_finite())?;
        let gain = ErrorReduction::of(&before, &trial);
        let gained_nothing = (self.was_lawful && gain.part < STALL_FRACTION)
            || (trial.error < PHASE_LOSS_ERROR && EQUAL_ERROR_RATIO * gain.factor < 1.0);
        self.stalls = if gained_nothing { self.stalls + 1 } else { 0 };
        self.was_lawful |= gain.is_lawful();
        self.gained_little |= gain.before < ORDER_LAW_ERROR && gain.part < 1.0 - ORDER_LAW_TOLERANCE;
        Some(gain)
    }
}

impl<L: Trials> Search<L> {
    /// Tries larger and larger numbers of steps of a scheme, from `coarsest` on. Stops if a trial
    /// meets the tolerance, or if no further trial can be the cheapest.
    pub fn refine_steps(&mut self, scheme: Scheme, coarsest: u64) -> RefinementResult {
        self.refine_at_most(scheme, coarsest, RUNGS)
    }

    pub(super) fn refine_at_most(&mut self, scheme: Scheme, coarsest: u64, rungs: usize) -> RefinementResult {
        let share = self.rules.share;
        let (mut steps, mut climb) = (coarsest, RefinementResult::default());
        for _ in 0..rungs {
            if self.cost(scheme, steps as f64) >= self.least_cost() {
                break;
            }
            // If the trial with `steps` takes too long, twice the previous number is tried.
            let next = climb.finest.map_or(steps, |before| before.steps.saturating_mul(2));
            let mut rungs = [steps, next].into_iter();
            let Some(trial) = rungs.find_map(|steps| self.trial(scheme, steps, share)) else { break };
            let gain = climb.add(trial);
            if trial.error <= self.enough() {
                break;
            }
            if climb.stalls >= STALLS_BEFORE_CHECK {
                // Rounding errors vary with ε, so another trial near the tolerance may succeed by
                // chance.
                let is_near = trial.error <= ROUNDING_VARIATION * self.tolerance && self.best().is_some();
                if !is_near && self.has_roundings(&trial) {
                    climb.has_stalled = true;
                    break;
                }
                // Coarse steps of a stiff motion may meet poles that finer steps avoid, so the
                // trials continue.
                climb.stalls = 0;
            }
            steps = if self.rules.leaps { trial.steps } else { steps }.saturating_mul(2);
            if let Some(gain) = gain.filter(|gain| trial.error < PHASE_LOSS_ERROR && gain.factor > 2.0) {
                let enough = Self::steps_by_order_law(&trial, 0.9 * self.rules.enough * self.tolerance);
                let is_dear = self.cost(scheme, enough) > self.rules.surely * self.least_cost();
                if is_dear || self.trials.gives_up(scheme, steps, enough, share) {
                    break;
                }
                // The trials up to the predicted number of steps are skipped.
                if self.rules.leaps && gain.is_lawful() {
                    steps = (enough.ceil() as u64)
                        .clamp(trial.steps + 1, trial.steps.saturating_mul(MAX_STEPS_RATIO));
                }
            }
        }
        climb
    }

    /// Returns whether rounding dominates the error of a trial, because the error in `Dd` is
    /// smaller.
    pub(super) fn has_roundings(&mut self, trial: &Setting) -> bool {
        let wide = PLAIN_DOUBLE_DOUBLE.composed(trial.scheme.composition);
        let other = if trial.scheme == wide { None } else { self.trial(wide, trial.steps, self.rules.share) };
        other.is_none_or(|other| other.error < EQUAL_ERROR_RATIO * trial.error)
    }

    /// Returns the largest number of steps at which plain `f64` followed the law error ∝ ε^order.
    pub(super) fn steps_with_order_law(&self, composition: Composition, coarsest: u64) -> u64 {
        let scheme = PLAIN_DOUBLE.composed(composition);
        let mut plain: Vec<&Setting> = self.tried.iter().filter(|trial| trial.scheme == scheme).collect();
        plain.sort_by_key(|trial| trial.steps);
        let is_lawful =
            |pair: &&[&Setting]| ErrorReduction::of(pair[0], pair[1]).part > 1.0 - ORDER_LAW_TOLERANCE;
        plain.windows(2).filter(is_lawful).map(|pair| pair[1].steps).max().unwrap_or(coarsest)
    }
}
