//! Which settings to try: as few as make the answer clear.
//!
//! In: what a step of each kind costs, and trials that tell the error of so many steps. Out: the
//! cheapest setting that was seen to serve. For each order a ladder of more and more steps
//! ([`ladder`]); a second method for what trials are compared with ([`vouch`]); then, between the
//! last rung that fails and the first that serves, the law error ∝ ε^order. The law says only what
//! to try next: what is chosen has been tried.

mod ladder;
mod vouch;

use core::cmp::Ordering;
use std::vec::Vec;

use crate::Composition;

use super::Precision;
use super::setting::{Kind, Mode};

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
/// The orders' compositions; the others need more stages for the same error.
const ORDERS: [Composition; 4] =
    [Composition::KAHAN_LI_8, Composition::KAHAN_LI_6, Composition::SUZUKI_4, Composition::KAHAN];

/// What tells errors and prices.
pub(super) trait Trials {
    /// The number of steps to take where about so many are wanted, at least as many.
    fn steps_near(&self, kind: Kind, steps: u64) -> u64;

    /// The error of so many steps over the horizon; infinite where it is beyond use, `None` where
    /// it takes too long to find out. That is what would take more than this part of the time that
    /// is left.
    fn error(&mut self, kind: Kind, steps: u64, share: f64) -> Option<f64>;

    /// What a step costs.
    fn price(&self, kind: Kind) -> f64;
}

/// A setting that was tried.
#[derive(Clone, Copy, Debug)]
struct Trial {
    kind: Kind,
    steps: u64,
    error: f64,
    cost: f64,
}

/// The answer.
#[derive(Clone, Copy, Debug)]
pub(super) enum Verdict {
    /// The cheapest of what serves, with an error that has the doubt about the flow in it.
    Choice { kind: Kind, steps: u64, error: f64 },
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
    modes: &'static [Mode],
    tried: Vec<Trial>,
    /// Whether roundings were seen in some ladder, or in the flow.
    is_rough: bool,
}

impl<L: Trials> Search<L> {
    pub(super) fn new(trials: L, tolerance: f64, modes: &'static [Mode]) -> Self {
        Self { trials, tolerance, modes, tried: Vec::new(), is_rough: false }
    }

    pub(super) fn trials(&self) -> &L {
        &self.trials
    }

    /// Tries until the answer is clear; `coarsest` is the least number of steps over the horizon.
    pub(super) fn run(&mut self, coarsest: u64) -> Verdict {
        // High orders first: something that serves ends the ladders of others early.
        for composition in ORDERS {
            self.climb(composition, coarsest);
            if self.best().is_none() && self.is_rough {
                // Finer steps round more often.
                break;
            }
        }
        if self.is_vouched_for() {
            let modes = [Mode::PLAIN].into_iter().chain(self.modes.iter().copied());
            for (mode, composition) in modes.flat_map(|mode| ORDERS.map(|order| (mode, order))) {
                self.refine(mode.kind(composition));
            }
            if self.is_uneven() {
                for composition in ORDERS {
                    self.scan(Mode::PLAIN.kind(composition), coarsest);
                }
            }
        }
        let least_error = self.tried.iter().map(|trial| trial.error).fold(f64::INFINITY, f64::min);
        match self.best() {
            Some(Trial { kind, steps, error, .. }) if self.is_vouched_for() => {
                Verdict::Choice { kind, steps, error: (error + least_error).min(self.tolerance) }
            }
            _ => Verdict::None { least_error, is_rough: self.is_rough },
        }
    }

    /// A trial of about so many steps, remembered.
    fn trial(&mut self, kind: Kind, steps: u64, share: f64) -> Option<Trial> {
        let steps = self.trials.steps_near(kind, steps);
        let known = self.tried.iter().find(|trial| trial.kind == kind && trial.steps == steps);
        if let Some(known) = known {
            return Some(*known);
        }
        let error = self.trials.error(kind, steps, share)?;
        let trial = Trial { kind, steps, error, cost: self.cost(kind, steps as f64) };
        self.tried.push(trial);
        Some(trial)
    }

    fn cost(&self, kind: Kind, steps: f64) -> f64 {
        self.trials.price(kind) * steps
    }

    /// The cheapest that serves; of several at one cost the most accurate.
    fn best(&self) -> Option<Trial> {
        let serve = self.tried.iter().filter(|trial| trial.error <= ENOUGH * self.tolerance);
        let order = |a: &&Trial, b: &&Trial| -> Ordering {
            a.cost.total_cmp(&b.cost).then(a.error.total_cmp(&b.error))
        };
        serve.min_by(order).copied()
    }

    fn least_cost(&self) -> f64 {
        self.best().map_or(f64::INFINITY, |best| best.cost)
    }

    /// Whether double-double, which has no roundings in common with anything, came as near to the
    /// flow as it must.
    fn is_vouched_for(&self) -> bool {
        let vouches = |trial: &Trial| VOUCHING * trial.error <= self.tolerance;
        self.tried.iter().any(|trial| trial.kind.precision == Precision::DoubleDouble && vouches(trial))
    }

    /// The steps at which the orders' law would meet an error.
    fn by_law(trial: &Trial, error: f64) -> f64 {
        trial.steps as f64 * (trial.error / error).powf(1.0 / f64::from(trial.kind.composition.order()))
    }

    /// Whether finer steps were seen to err more, and not for roundings: where a motion is stiff,
    /// steps of some sizes meet poles of the map, and there is more than one stretch of sizes that
    /// serve.
    fn is_uneven(&self) -> bool {
        let plain = |trial: &&Trial| trial.kind == Mode::PLAIN.kind(trial.kind.composition);
        let is_worse = |coarse: &Trial, fine: &Trial| {
            coarse.kind == fine.kind
                && coarse.steps < fine.steps
                && coarse.error < SMALL
                && coarse.error < STALL * fine.error
        };
        let mut coarse = self.tried.iter().filter(plain);
        !self.is_rough && coarse.any(|coarse| self.tried.iter().any(|fine| is_worse(coarse, fine)))
    }

    /// Tries all sizes of steps, as far as they cost less than what is known to serve.
    fn scan(&mut self, kind: Kind, coarsest: u64) {
        let mut steps = coarsest;
        while CLOSE * self.cost(kind, steps as f64) < self.least_cost()
            && self.trial(kind, steps, SHARE).is_some()
        {
            steps = (GRID * steps as f64).ceil() as u64;
        }
    }

    /// Looks for fewer steps that still serve.
    fn refine(&mut self, kind: Kind) {
        for _ in 0..TRIALS {
            let dearest = self.least_cost() / self.trials.price(kind);
            let fails = |trial: &&Trial| trial.kind == kind && trial.error > ENOUGH * self.tolerance;
            let cheaper = |trial: &&Trial| (trial.steps as f64) < dearest;
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
            if steps as f64 >= dearest || self.trial(kind, steps, SHARE).is_none() {
                return;
            }
        }
    }
}
