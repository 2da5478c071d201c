//! A search for the cheapest setting, in as few trials as make the answer clear.
//!
//! In: [`Trials`], which return the error of a setting and the price of a step: operations counted
//! by the plans ([`Scene::choose`](crate::Scene::choose)), or nanoseconds measured (`kahan trade`).
//! Out: the cheapest setting whose measured error serves. A [ladder](Search::ladder) tries more and
//! more steps of a scheme. [`refine`](Search::refine) looks between its last rung that fails and
//! the first that serves, by the law error ∝ ε^order. The law proposes trials; the chosen setting
//! is always one that was tried.

mod choose;
mod ladder;
#[cfg(test)]
mod tests;
mod vouch;

use super::{Precision, Scheme, Setting};

pub use ladder::Climb;

pub(super) use choose::{OF_DOUBLE, OTHERS, PLAIN, VOUCHING, Verdict, WIDE};

/// Errors above this say nothing: trajectories have lost their phase.
const SMALL: f64 = 0.1;
/// Errors that differ by a factor nearer to 1 than this do not differ.
const STALL: f64 = 0.7;
/// Steps that differ by less than this factor are not told apart.
const CLOSE: f64 = 1.06;
/// Where errors fall unevenly, steps that differ by this factor are tried.
const GRID: f64 = 1.1;
/// Trials between two rungs.
const TRIALS: usize = 5;

/// Settings run, and the price of their steps.
pub trait Trials {
    /// Returns the setting of a scheme with about this number of steps.
    fn setting(&self, scheme: Scheme, steps: u64) -> Setting;

    /// The error of a setting; infinite where it is beyond use, `None` where finding out takes more
    /// than `share` of the time that is left.
    fn error(&mut self, setting: &Setting, share: f64) -> Option<f64>;

    /// The price of one step.
    fn price(&self, scheme: Scheme) -> f64;

    /// The price of a setting, of which the least is looked for.
    fn cost(&self, setting: &Setting) -> f64 {
        self.price(setting.scheme) * setting.steps as f64
    }

    /// Whether to give up a ladder before the rung of `next` steps, since its end, at about `end`
    /// steps, takes more than `share` of the time that is left.
    fn gives_up(&mut self, _scheme: Scheme, _next: u64, _end: f64, _share: f64) -> bool {
        false
    }
}

/// How eagerly a search goes on.
#[derive(Clone, Copy, Debug)]
pub struct Rules {
    /// The part of the tolerance that a setting's error may be.
    pub enough: f64,
    /// The part of that error which [`Search::refine`] aims at,
    pub aim: f64,
    /// and this factor takes more steps than the law has it.
    pub surplus: f64,
    /// Whether ladders leave out rungs where the law is seen to hold. The rungs between are on the
    /// picture of a search whose trials are shown.
    pub leaps: bool,
    /// The factor by which the law may have a ladder's end cost more than what is known to serve.
    pub surely: f64,
    /// The part of the time that is left that one trial may take.
    pub share: f64,
}

/// Trials and what they showed.
#[derive(Debug)]
pub struct Search<L> {
    trials: L,
    tolerance: f64,
    rules: Rules,
    /// What was tried, with the errors seen.
    tried: Vec<Setting>,
    /// Whether roundings were seen in some ladder, or in the flow.
    is_rough: bool,
}

impl<L: Trials> Search<L> {
    /// A search for a setting that errs by at most [`Rules::enough`] of this tolerance.
    #[must_use]
    pub const fn new(trials: L, tolerance: f64, rules: Rules) -> Self {
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

    /// Returns the trials and ends the search.
    #[must_use]
    pub fn into_trials(self) -> L {
        self.trials
    }

    /// Sets the part of the time that is left that one trial may take.
    pub const fn set_share(&mut self, share: f64) {
        self.rules.share = share;
    }

    /// Whether some setting of a scheme was tried.
    #[must_use]
    pub fn has_tried(&self, scheme: Scheme) -> bool {
        self.tried.iter().any(|trial| trial.scheme == scheme)
    }

    /// Returns the cheapest that serves; of several at one cost the most accurate.
    #[must_use]
    pub fn best(&self) -> Option<Setting> {
        let serve = self.tried.iter().filter(|trial| trial.error <= self.enough());
        let cost = |trial: &Setting| self.trials.cost(trial);
        serve.min_by(|a, b| cost(a).total_cmp(&cost(b)).then(a.error.total_cmp(&b.error))).copied()
    }

    /// The error that serves.
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

    /// The steps at which the orders' law would meet an error.
    fn by_law(trial: &Setting, error: f64) -> f64 {
        trial.steps as f64 * (trial.error / error).powf(1.0 / f64::from(trial.scheme.order()))
    }

    /// Whether finer steps were seen to err more in `f64`, at errors that are seldom roundings,
    /// which are above `roundings`. Where a motion is stiff, steps of some sizes meet poles of the
    /// map, and there is more than one stretch of sizes that serve.
    #[must_use]
    pub fn is_uneven(&self, roundings: f64) -> bool {
        let plain = |trial: &&Setting| trial.scheme == PLAIN.composed(trial.scheme.composition);
        let is_worse = |coarse: &Setting, fine: &Setting| {
            coarse.scheme == fine.scheme
                && coarse.steps < fine.steps
                && (roundings..SMALL).contains(&coarse.error)
                && coarse.error < STALL * fine.error
        };
        let mut coarse = self.tried.iter().filter(plain);
        !self.is_rough && coarse.any(|coarse| self.tried.iter().any(|fine| is_worse(coarse, fine)))
    }

    /// Tries all sizes of steps, as far as they cost less than what is known to serve.
    pub fn scan(&mut self, scheme: Scheme, coarsest: u64) {
        let mut steps = coarsest;
        while CLOSE * self.cost(scheme, steps as f64) < self.least_cost()
            && self.trial(scheme, steps, self.rules.share).is_some()
        {
            steps = (GRID * steps as f64).ceil() as u64;
        }
    }

    /// Looks for fewer steps that still serve.
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
            let Rules { enough, aim, surplus, .. } = self.rules;
            let guess = match surplus * Self::by_law(&last, aim * enough * self.tolerance) {
                guess if guess.is_finite() => guess,
                _ => (low * dearest).sqrt(),
            };
            if dearest / low < CLOSE || guess >= CLOSE * dearest {
                return;
            }
            // Of few steps the next number may be the one.
            let steps = (guess.clamp(1.02 * low, 0.98 * dearest).round() as u64).max(last.steps + 1);
            if steps as f64 >= dearest || self.trial(scheme, steps, self.rules.share).is_none() {
                return;
            }
        }
    }
}
