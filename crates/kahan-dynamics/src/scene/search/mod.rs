//! Which settings to try: as few as make the answer clear.
//!
//! In: what a step of each scheme costs, and trials that tell the error of so many steps. Out: the
//! cheapest setting that was seen to serve. For each order a ladder of more and more steps
//! ([`ladder`]); a second method for what trials are compared with ([`vouch`]); then, between the
//! last rung that fails and the first that serves, the law error ∝ ε^order. The law says only what
//! to try next: what is chosen has been tried.

mod ladder;
mod vouch;

use kahan_core::Composition;

use super::{Precision, Scheme, Setting};

/// A setting serves whose error against the flow is at most this part of the tolerance.
const ENOUGH: f64 = 0.85;
/// A trial vouches for the flow that comes so many times nearer to it than the tolerance: two
/// methods that are independent, and agree.
pub(super) const VOUCHING: f64 = 10.0;
/// Errors above this say nothing: trajectories have lost their phase.
const SMALL: f64 = 0.1;
/// Errors that differ by a factor nearer to 1 than this do not differ.
const STALL: f64 = 0.7;
/// The part of the time that is left that one trial may take, so that there is some for what
/// vouches.
const SHARE: f64 = 0.45;
/// Steps that differ by less than this factor are not told apart.
const CLOSE: f64 = 1.06;
/// Where errors fall unevenly, steps that differ by this factor are tried.
const GRID: f64 = 1.1;
/// Trials between two rungs.
const TRIALS: usize = 5;

/// What is tried first.
pub(super) const PLAIN: Scheme = Scheme::of(Precision::Double);
/// `Dd`, whose roundings are never seen.
pub(super) const WIDE: Scheme = Scheme::of(Precision::DoubleDouble);
/// What a single orbit may be chosen to run in besides plain `f64`. Not `f32`, for which it waits
/// as long.
pub(super) const OTHERS: [Scheme; 2] = [WIDE, PLAIN.compensated()];
/// Those of them in `f64`.
pub(super) const OF_DOUBLE: [Scheme; 1] = [PLAIN.compensated()];

/// What tells errors and prices.
pub(super) trait Trials {
    /// The setting to take where about so many steps are wanted; it has at least as many.
    fn setting(&self, scheme: Scheme, steps: u64) -> Setting;

    /// The error of a setting; infinite where it is beyond use, `None` where it takes too long to
    /// find out. That is what would take more than this part of the time that is left.
    fn error(&mut self, setting: &Setting, share: f64) -> Option<f64>;

    /// What a step costs.
    fn price(&self, scheme: Scheme) -> f64;
}

/// The answer.
#[derive(Clone, Copy, Debug)]
pub(super) enum Verdict {
    /// The cheapest of what serves, with an error that has the doubt about the flow in it.
    Choice(Setting),
    /// Nothing serves, or nothing vouches for the flow.
    None {
        /// Of all trials.
        least_error: f64,
        /// Whether roundings were seen in some ladder, or in the flow.
        is_rough: bool,
    },
}

/// Trials and what they showed.
pub(super) struct Search<L> {
    trials: L,
    tolerance: f64,
    /// The numbers that may be chosen besides plain `f64`.
    others: &'static [Scheme],
    /// What was tried, with the errors seen.
    tried: Vec<Setting>,
    /// Whether roundings were seen in some ladder, or in the flow.
    is_rough: bool,
}

impl<L: Trials> Search<L> {
    pub(super) fn new(trials: L, tolerance: f64, others: &'static [Scheme]) -> Self {
        Self { trials, tolerance, others, tried: Vec::new(), is_rough: false }
    }

    pub(super) fn trials(&self) -> &L {
        &self.trials
    }

    /// Tries until the answer is clear; `coarsest` is the least number of steps over the horizon.
    pub(super) fn run(&mut self, coarsest: u64) -> Verdict {
        // High orders first: something that serves ends the ladders of others early.
        for composition in Composition::BEST.into_iter().rev() {
            self.climb(composition, coarsest);
            if self.best().is_none() && self.is_rough {
                // Finer steps round more often.
                break;
            }
        }
        if self.is_vouched_for() {
            for scheme in [&[PLAIN], self.others].concat() {
                for composition in Composition::BEST.into_iter().rev() {
                    self.refine(scheme.composed(composition));
                }
            }
            if self.is_uneven() {
                for composition in Composition::BEST.into_iter().rev() {
                    self.scan(PLAIN.composed(composition), coarsest);
                }
            }
        }
        let least_error = self.tried.iter().map(|trial| trial.error).fold(f64::INFINITY, f64::min);
        match self.best() {
            Some(best) if self.is_vouched_for() => {
                let error = (best.error + least_error).min(self.tolerance);
                Verdict::Choice(Setting { error, ..best })
            }
            _ => Verdict::None { least_error, is_rough: self.is_rough },
        }
    }

    /// A trial of about so many steps, remembered.
    fn trial(&mut self, scheme: Scheme, steps: u64, share: f64) -> Option<Setting> {
        let setting = self.trials.setting(scheme, steps);
        let known = self.tried.iter().find(|trial| trial.scheme == scheme && trial.steps == setting.steps);
        if let Some(known) = known {
            return Some(*known);
        }
        let error = self.trials.error(&setting, share)?;
        let trial = Setting { error, ..setting };
        self.tried.push(trial);
        Some(trial)
    }

    fn cost(&self, scheme: Scheme, steps: f64) -> f64 {
        self.trials.price(scheme) * steps
    }

    /// The cheapest that serves; of several at one cost the most accurate.
    fn best(&self) -> Option<Setting> {
        let serve = self.tried.iter().filter(|trial| trial.error <= ENOUGH * self.tolerance);
        let cost = |trial: &Setting| self.cost(trial.scheme, trial.steps as f64);
        serve.min_by(|a, b| cost(a).total_cmp(&cost(b)).then(a.error.total_cmp(&b.error))).copied()
    }

    fn least_cost(&self) -> f64 {
        self.best().map_or(f64::INFINITY, |best| self.cost(best.scheme, best.steps as f64))
    }

    /// Whether double-double, which has no roundings in common with anything, came as near to the
    /// flow as it must.
    fn is_vouched_for(&self) -> bool {
        let vouches = |trial: &Setting| VOUCHING * trial.error <= self.tolerance;
        self.tried.iter().any(|trial| trial.scheme.precision == Precision::DoubleDouble && vouches(trial))
    }

    /// The steps at which the orders' law would meet an error.
    fn by_law(trial: &Setting, error: f64) -> f64 {
        trial.steps as f64 * (trial.error / error).powf(1.0 / f64::from(trial.scheme.order()))
    }

    /// Whether finer steps were seen to err more, and not for roundings: where a motion is stiff,
    /// steps of some sizes meet poles of the map, and there is more than one stretch of sizes that
    /// serve.
    fn is_uneven(&self) -> bool {
        let plain = |trial: &&Setting| trial.scheme == PLAIN.composed(trial.scheme.composition);
        let is_worse = |coarse: &Setting, fine: &Setting| {
            coarse.scheme == fine.scheme
                && coarse.steps < fine.steps
                && coarse.error < SMALL
                && coarse.error < STALL * fine.error
        };
        let mut coarse = self.tried.iter().filter(plain);
        !self.is_rough && coarse.any(|coarse| self.tried.iter().any(|fine| is_worse(coarse, fine)))
    }

    /// Tries all sizes of steps, as far as they cost less than what is known to serve.
    fn scan(&mut self, scheme: Scheme, coarsest: u64) {
        let mut steps = coarsest;
        while CLOSE * self.cost(scheme, steps as f64) < self.least_cost()
            && self.trial(scheme, steps, SHARE).is_some()
        {
            steps = (GRID * steps as f64).ceil() as u64;
        }
    }

    /// Looks for fewer steps that still serve.
    fn refine(&mut self, scheme: Scheme) {
        for _ in 0..TRIALS {
            let dearest = self.least_cost() / self.trials.price(scheme);
            let fails = |trial: &&Setting| trial.scheme == scheme && trial.error > ENOUGH * self.tolerance;
            let cheaper = |trial: &&Setting| (trial.steps as f64) < dearest;
            let last = self.tried.iter().filter(fails).filter(cheaper).max_by_key(|trial| trial.steps);
            let Some(last) = last.copied() else { return };
            let low = last.steps as f64;
            let guess = match Self::by_law(&last, 0.97 * ENOUGH * self.tolerance) {
                guess if guess.is_finite() => guess,
                _ => (low * dearest).sqrt(),
            };
            if dearest / low < CLOSE || guess >= CLOSE * dearest {
                return;
            }
            // Of few steps the next number may be the one.
            let steps = (guess.clamp(1.02 * low, 0.98 * dearest).round() as u64).max(last.steps + 1);
            if steps as f64 >= dearest || self.trial(scheme, steps, SHARE).is_none() {
                return;
            }
        }
    }
}
