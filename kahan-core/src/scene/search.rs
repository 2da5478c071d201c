//! Which settings to try: as few as make the answer clear.
//!
//! In: what a step of each kind costs, and trials that tell the error of so many steps. Out: the cheapest setting that was seen to
//! serve. For each order a ladder of more and more steps, until one serves, or costs more than a setting that does, or is sure to
//! by the law error ∝ ε^order, or gains nothing any more; then between the last rung that fails and the first that serves, by the
//! same law. A law says only what to try next: what is chosen has been tried.

use core::cmp::Ordering;
use std::vec::Vec;

use crate::Composition;

use super::Precision;
use super::setting::{Kind, Mode};

/// A setting serves whose error against the flow is at most this part of the tolerance,
const ENOUGH: f64 = 0.85;
/// where another trial came so many times nearer to the flow than the tolerance: two methods that are independent, and agree.
pub(super) const VOUCHING: f64 = 10.0;
/// By how much less than the law has it a rung may gain, in its logarithm, and is still taken to follow it.
const LAWFUL: f64 = 0.3;
/// A ladder ends where two rungs in a row gained less than this factor, below errors of a tenth (above, trajectories have lost
/// their phase, and the error says nothing).
const STALL: f64 = 0.7;
const SMALL: f64 = 0.1;
/// Where no rung has gained anything yet, it takes so many: a motion that grows from next to nothing is small to begin with,
/// whatever coarse steps make of it.
const PATIENCE: u32 = 6;
/// The most rungs of a ladder.
const RUNGS: usize = 34;
/// A ladder is given up where the law says that its end will cost this factor more than what is known to serve.
const SURELY: f64 = 1.5;
/// A ladder's longest step where the law is seen to hold.
const LEAP: u64 = 1 << 12;
/// Steps that differ by less than this factor are not told apart.
const CLOSE: f64 = 1.06;
/// Trials between two rungs.
const TRIALS: usize = 5;
/// Trials that may vouch for the flow.
const VOUCHERS: usize = 16;

/// The orders' compositions; the others need more stages for the same error.
const ORDERS: [Composition; 4] =
    [Composition::KAHAN_LI_8, Composition::KAHAN_LI_6, Composition::SUZUKI_4, Composition::KAHAN];

/// What tells errors and prices.
pub(super) trait Trials {
    /// The number of steps to take where about so many are wanted, at least as many.
    fn steps_near(&self, kind: Kind, steps: u64) -> u64;

    /// The error of so many steps over the horizon; infinite where it is beyond use, `None` where it takes too long to find out.
    fn error(&mut self, kind: Kind, steps: u64) -> Option<f64>;

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
        /// Whether the errors of some ladder fell, and then no further.
        is_rough: bool,
    },
}

/// What a rung gained on the one before.
#[derive(Clone, Copy, Debug)]
struct Gain {
    /// The error before,
    before: f64,
    /// over the error now.
    factor: f64,
    /// The same as a part of what the law has it, in logarithms.
    part: f64,
}

impl Gain {
    fn of(before: &Trial, now: &Trial) -> Self {
        let factor = before.error / now.error;
        let by_law = (now.steps as f64 / before.steps as f64).powi(now.kind.composition.order() as i32);
        Self { before: before.error, factor, part: factor.ln() / by_law.ln() }
    }
}

/// How a ladder ended.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Roundings {
    /// The errors fell as the order has it.
    Unseen,
    /// They fell less: there were roundings in them, which compensation makes fewer.
    Felt,
}

/// Trials and what they showed.
pub(super) struct Search<L> {
    trials: L,
    tolerance: f64,
    /// The numbers that may be chosen.
    modes: &'static [Mode],
    tried: Vec<Trial>,
    /// Whether the errors of some ladder fell, and then no further.
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
            for (mode, composition) in self.modes.iter().flat_map(|mode| ORDERS.map(|order| (mode, order))) {
                self.refine(mode.kind(composition));
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
    fn trial(&mut self, kind: Kind, steps: u64) -> Option<Trial> {
        let steps = self.trials.steps_near(kind, steps);
        let known = self.tried.iter().find(|trial| trial.kind == kind && trial.steps == steps);
        if let Some(known) = known {
            return Some(*known);
        }
        let error = self.trials.error(kind, steps)?;
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

    /// Whether double-double, which has no roundings in common with anything, came as near to the flow as it must.
    fn is_vouched_for(&self) -> bool {
        let wide = self.tried.iter().filter(|trial| trial.kind.precision == Precision::DoubleDouble);
        wide.into_iter().any(|trial| VOUCHING * trial.error <= self.tolerance)
    }

    /// The steps at which the orders' law would meet an error.
    fn by_law(trial: &Trial, error: f64) -> f64 {
        trial.steps as f64 * (trial.error / error).powf(1.0 / f64::from(trial.kind.composition.order()))
    }

    /// The finest steps of an order at which the roundings of `f64` are not yet felt.
    fn smooth(&self, composition: Composition, coarsest: u64) -> u64 {
        const SEEN: f64 = 1e-9;
        let of_order = self.tried.iter().filter(|trial| trial.kind.composition == composition);
        let smooth = of_order.filter(|trial| trial.error > SEEN.max(self.tolerance));
        smooth.map(|trial| trial.steps).max().unwrap_or(coarsest)
    }

    /// The ladders of an order: each mode's where the roundings of the one before were felt. What then serves is vouched for.
    fn climb(&mut self, composition: Composition, coarsest: u64) {
        let mut from = coarsest;
        for mode in self.modes {
            let roundings = self.ladder(mode.kind(composition), from);
            if roundings == Roundings::Unseen {
                break;
            }
            from = self.smooth(composition, coarsest);
        }
        if self.best().is_some() && !self.is_vouched_for() {
            self.vouch();
        }
    }

    fn ladder(&mut self, kind: Kind, coarsest: u64) -> Roundings {
        let (mut steps, mut before): (u64, Option<Trial>) = (coarsest, None);
        let (mut roundings, mut has_gained, mut stalls) = (Roundings::Unseen, false, 0);
        for _ in 0..RUNGS {
            if self.cost(kind, steps as f64) >= self.least_cost() {
                break;
            }
            // Where a leap takes too long, the next rung may not.
            let next = before.map_or(steps, |before| 2 * before.steps);
            let Some(trial) = [steps, next].into_iter().find_map(|steps| self.trial(kind, steps)) else {
                break;
            };
            let error = trial.error;
            let gain =
                before.filter(|before| before.error.is_finite()).map(|before| Gain::of(&before, &trial));
            if gain.is_some_and(|gain| gain.before < 0.1 * SMALL && gain.part < 1.0 - LAWFUL) {
                roundings = Roundings::Felt;
            }
            if error <= ENOUGH * self.tolerance {
                break;
            }
            stalls = match gain {
                Some(gain) if error < SMALL && STALL * gain.factor < 1.0 => stalls + 1,
                _ => 0,
            };
            has_gained |= gain.is_some_and(|gain| gain.factor > 2.0);
            if stalls == if has_gained { 2 } else { PATIENCE } {
                self.is_rough |= has_gained;
                break;
            }
            steps = 2 * trial.steps;
            if let Some(gain) = gain.filter(|gain| error < SMALL && gain.factor > 2.0) {
                let enough = Self::by_law(&trial, 0.9 * ENOUGH * self.tolerance);
                if self.cost(kind, enough) > SURELY * self.least_cost() {
                    break;
                }
                // Where the law is seen to hold, there is no need of the rungs between.
                if (gain.part - 1.0).abs() < LAWFUL && error < 0.1 * SMALL {
                    steps = (enough.ceil() as u64).clamp(trial.steps + 1, trial.steps.saturating_mul(LEAP));
                }
            }
            before = Some(trial);
        }
        roundings
    }

    /// Looks for an orbit in double-double that is so near to the flow that both must be right.
    fn vouch(&mut self) {
        let wanted = self.tolerance / VOUCHING;
        for _ in 0..VOUCHERS {
            // Of the order that gets there with the fewest stages, by what its last trials showed.
            let next = ORDERS
                .iter()
                .filter_map(|order| Some((Mode::WIDE.kind(*order), self.steps_to(*order, wanted)?)));
            let stages = |(kind, steps): &(Kind, u64)| *steps as f64 * kind.composition.stages() as f64;
            let Some((kind, steps)) = next.min_by(|a, b| stages(a).total_cmp(&stages(b))) else {
                // It is the flow that has roundings.
                self.is_rough = true;
                return;
            };
            if self.trial(kind, steps).is_none_or(|trial| trial.error <= wanted) {
                return;
            }
        }
    }

    /// The steps at which an order may come so near: by the law, from its finest trial in double-double, or its best in `f64`.
    /// `None` where trials come no nearer.
    fn steps_to(&self, composition: Composition, wanted: f64) -> Option<u64> {
        let of_order = || self.tried.iter().filter(|trial| trial.kind.composition == composition);
        let by_law = |trial: &Trial| Self::by_law(trial, 0.7 * wanted);
        let mut wide: Vec<&Trial> =
            of_order().filter(|trial| trial.kind == Mode::WIDE.kind(composition)).collect();
        wide.sort_by_key(|trial| core::cmp::Reverse(trial.steps));
        let Some(finest) = wide.first() else {
            let useful = of_order().filter(|trial| trial.error < SMALL.max(self.tolerance));
            return useful
                .min_by(|a, b| a.error.total_cmp(&b.error))
                .map(|best| by_law(best).ceil().max(1.0) as u64);
        };
        let stalls =
            wide.windows(2).take_while(|pair| pair[0].error < SMALL && pair[0].error > STALL * pair[1].error);
        if stalls.count() > 1 {
            return None;
        }
        let steps = finest.steps as f64;
        // The law tells the least; where it does not hold yet, more are needed.
        let next =
            if finest.error < SMALL { by_law(finest).clamp(1.3 * steps, 4.0 * steps) } else { 2.0 * steps };
        Some(next.ceil() as u64)
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
            if steps as f64 >= dearest || self.trial(kind, steps).is_none() {
                return;
            }
        }
    }
}
