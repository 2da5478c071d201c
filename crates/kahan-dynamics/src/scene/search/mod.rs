//! A search for the cheapest setting in few trials.
//!
//! The input is [`Trials`], which return the error of a setting and the price of a step: counted
//! operations ([`Scene::choose`](crate::Scene::choose)) or measured nanoseconds (`kahan trade`).
//! The output is the cheapest setting whose measured error meets the tolerance.
//!
//! # Method
//!
//! [`refine_steps`](Search::refine_steps) tries larger and larger numbers of steps of one scheme.
//! [`refine`](Search::refine) searches between the scheme's last failure and the cost of the best
//! setting. The law error ∝ ε^order proposes trials and ends hopeless ones.

mod choose;
mod confirmation;
mod refinement;
#[cfg(test)]
mod tests;

use super::{Precision, Scheme, Setting};

pub use refinement::RefinementResult;

pub(super) use choose::{
    ALTERNATIVES_TO_DOUBLE, OF_DOUBLE, PLAIN_DOUBLE, PLAIN_DOUBLE_DOUBLE, REFERENCE_ACCURACY_FACTOR, Verdict,
};

/// The error above which the orbit has lost the phase of the trajectory.
const PHASE_LOSS_ERROR: f64 = 0.1;
/// Two errors are treated as equal if the smaller divided by the larger exceeds this.
const EQUAL_ERROR_RATIO: f64 = 0.7;
/// Two numbers of steps are treated as equal if the larger divided by the smaller is below this.
const EQUAL_STEPS_RATIO: f64 = 1.06;
const GRID: f64 = 1.1;
const TRIALS: usize = 5;

/// Runs settings, and returns their errors and the prices of their steps.
pub trait Trials {
    /// Returns the setting of a scheme with about this number of steps.
    fn setting(&self, scheme: Scheme, steps: u64) -> Setting;

    /// Returns the error of a setting, or infinity for a very large error. Returns `None` if the
    /// trial takes more than the fraction `share` of the remaining time.
    fn error(&mut self, setting: &Setting, share: f64) -> Option<f64>;

    /// Returns the price of one step.
    fn price(&self, scheme: Scheme) -> f64;

    /// Returns the price of a setting, which the search minimises.
    fn cost(&self, setting: &Setting) -> f64 {
        self.price(setting.scheme) * setting.steps as f64
    }

    /// Returns whether to stop a scheme before its trial with `_next` steps. The search predicts
    /// success with `_end` steps. A trial may take the fraction `_share` of the remaining time.
    fn gives_up(&mut self, _scheme: Scheme, _next: u64, _end: f64, _share: f64) -> bool {
        false
    }
}

/// The parameters of a search.
#[derive(Clone, Copy, Debug)]
pub struct SearchParameters {
    /// The fraction of the tolerance up to which an error is accepted.
    pub enough: f64,
    /// The error at which [`Search::refine`] aims, divided by the largest accepted error.
    pub aim: f64,
    /// A factor, at least 1, for the number of steps that the law error ∝ ε^order predicts.
    pub surplus: f64,
    /// Whether the search skips numbers of steps once errors follow the law error ∝ ε^order. Plots
    /// set this to `false` to get more trials.
    pub leaps: bool,
    /// The trials of a scheme stop if its predicted cost is more than this many times the least
    /// known cost.
    pub surely: f64,
    /// The fraction of the remaining time that one trial may take.
    pub share: f64,
}

/// A search with its trials and their results.
#[derive(Debug)]
pub struct Search<L> {
    trials: L,
    tolerance: f64,
    rules: SearchParameters,
    tried: Vec<Setting>,
    is_rough: bool,
}

impl<L: Trials> Search<L> {
    /// Prepares a search for a setting with an error of at most [`SearchParameters::enough`] ·
    /// `tolerance`.
    #[must_use]
    pub const fn new(trials: L, tolerance: f64, rules: SearchParameters) -> Self {
        Self { trials, tolerance, rules, tried: Vec::new(), is_rough: false }
    }

    /// Returns the trials.
    #[must_use]
    pub const fn trials(&self) -> &L {
        &self.trials
    }

    /// Returns the trials, mutably.
    pub const fn trials_mut(&mut self) -> &mut L {
        &mut self.trials
    }

    /// Ends the search and returns the trials.
    #[must_use]
    pub fn into_trials(self) -> L {
        self.trials
    }

    /// Sets the fraction of the remaining time that one trial may take.
    pub const fn set_share(&mut self, share: f64) {
        self.rules.share = share;
    }

    /// Returns whether some setting of a scheme was tried.
    #[must_use]
    pub fn has_tried(&self, scheme: Scheme) -> bool {
        self.tried.iter().any(|trial| trial.scheme == scheme)
    }

    /// Returns the cheapest accepted setting. Of several settings with equal cost, returns the most
    /// accurate one.
    #[must_use]
    pub fn best(&self) -> Option<Setting> {
        let serve = self.tried.iter().filter(|trial| trial.error <= self.enough());
        let cost = |trial: &Setting| self.trials.cost(trial);
        serve.min_by(|a, b| cost(a).total_cmp(&cost(b)).then(a.error.total_cmp(&b.error))).copied()
    }

    fn enough(&self) -> f64 {
        self.rules.enough * self.tolerance
    }

    /// Tries a setting with about this number of steps, or returns its earlier trial.
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

    fn least_cost(&self) -> f64 {
        self.best().map_or(f64::INFINITY, |best| self.trials.cost(&best))
    }

    /// Returns the number of steps at which the law error ∝ ε^order predicts this error.
    fn steps_by_order_law(trial: &Setting, error: f64) -> f64 {
        trial.steps as f64 * libm::pow(trial.error / error, 1.0 / f64::from(trial.scheme.order()))
    }

    /// Returns whether an error in `f64` above `roundings`, the rounding errors, grew with more
    /// steps. This happens if some step sizes meet poles.
    #[must_use]
    pub fn is_uneven(&self, roundings: f64) -> bool {
        let plain = |trial: &&Setting| trial.scheme == PLAIN_DOUBLE.composed(trial.scheme.composition);
        let is_worse = |coarse: &Setting, fine: &Setting| {
            coarse.scheme == fine.scheme
                && coarse.steps < fine.steps
                && (roundings..PHASE_LOSS_ERROR).contains(&coarse.error)
                && coarse.error < EQUAL_ERROR_RATIO * fine.error
        };
        let mut coarse = self.tried.iter().filter(plain);
        !self.is_rough && coarse.any(|coarse| self.tried.iter().any(|fine| is_worse(coarse, fine)))
    }

    /// Tries all step sizes on a geometric grid that cost less than the best setting.
    pub fn scan(&mut self, scheme: Scheme, coarsest: u64) {
        let mut steps = coarsest;
        while EQUAL_STEPS_RATIO * self.cost(scheme, steps as f64) < self.least_cost()
            && self.trial(scheme, steps, self.rules.share).is_some()
        {
            steps = (GRID * steps as f64).ceil() as u64;
        }
    }

    /// Searches for an accurate enough setting of the scheme that is cheaper than all known ones.
    pub fn refine(&mut self, scheme: Scheme) {
        for _ in 0..TRIALS {
            let dearest = self.least_cost() / self.trials.price(scheme);
            if !dearest.is_finite() {
                return;
            }
            let fails = |trial: &&Setting| trial.scheme == scheme && trial.error > self.enough();
            let cheaper = |trial: &&Setting| (trial.steps as f64) < dearest;
            let last = self.tried.iter().filter(fails).filter(cheaper).max_by_key(|trial| trial.steps);
            let Some(last) = last.copied() else { return };
            let low = last.steps as f64;
            let SearchParameters { enough, aim, surplus, .. } = self.rules;
            let guess = match surplus * Self::steps_by_order_law(&last, aim * enough * self.tolerance) {
                guess if guess.is_finite() => guess,
                _ => (low * dearest).sqrt(),
            };
            if dearest / low < EQUAL_STEPS_RATIO || guess >= EQUAL_STEPS_RATIO * dearest {
                return;
            }
            let steps = (guess.clamp(1.02 * low, 0.98 * dearest).round() as u64).max(last.steps + 1);
            if steps as f64 >= dearest || self.trial(scheme, steps, self.rules.share).is_none() {
                return;
            }
        }
    }
}
