//! Ladders: an order at more and more steps.
//!
//! In: a scheme and where to begin. Out: trials, until one serves, or costs more than a setting
//! that does, or is sure to by the law error ∝ ε^order, or two rungs in a row gain nothing; and
//! whether roundings were felt.

use kahan_core::Composition;

use super::super::{Scheme, Setting};
use super::{ENOUGH, PLAIN, SHARE, SMALL, STALL, Search, Trials, WIDE};

/// By how much less than the law has it a rung may gain, in its logarithm, and is still taken to
/// follow it.
const LAWFUL: f64 = 0.3;
/// The law is trusted below this error.
const USEFUL: f64 = 0.01;
/// So many rungs in a row that gain nothing want an explanation.
const STALLS: u32 = 2;
/// A rung that gained less than this part of what the law has it, in logarithms, gained nothing,
/// once the law was seen to hold.
const LITTLE: f64 = 0.3;
/// The most rungs of a ladder.
const RUNGS: usize = 34;
/// The most rungs of a ladder that begins where another felt roundings.
const MORE_RUNGS: usize = 5;
/// A ladder is given up where the law says that its end will cost this factor more than what is
/// known to serve.
const SURELY: f64 = 1.5;
/// Roundings differ from one ε to the next by about this factor.
const NEAR: f64 = 30.0;
/// A ladder's longest step where the law is seen to hold.
const LEAP: u64 = 1 << 12;

/// What a rung gained on the one before.
#[derive(Clone, Copy, Debug)]
struct Gain {
    /// The error before.
    before: f64,
    /// The error before over the error now.
    factor: f64,
    /// The same as a part of what the law has it, in logarithms.
    part: f64,
}

impl Gain {
    /// Whether the rung gained what the law has it, at errors at which it can be trusted.
    fn is_lawful(&self) -> bool {
        (self.part - 1.0).abs() < LAWFUL && self.before < self.factor * USEFUL
    }

    fn of(before: &Setting, now: &Setting) -> Self {
        let factor = before.error / now.error;
        let by_law = (now.steps as f64 / before.steps as f64).powi(now.scheme.order() as i32);
        Self { before: before.error, factor, part: factor.ln() / by_law.ln() }
    }
}

/// What a ladder has shown so far.
#[derive(Clone, Copy, Debug, Default)]
struct Climb {
    /// Whether some rung gained as the law has it.
    was_lawful: bool,
    /// Whether some rung gained less.
    gained_little: bool,
    /// How many rungs in a row gained nothing.
    stalls: u32,
    /// The finest rung.
    finest: Option<Setting>,
}

impl Climb {
    /// Counts what a rung gained on the one before, if there was one that said something.
    fn add(&mut self, trial: Setting) -> Option<Gain> {
        let before = self.finest.replace(trial).filter(|before| before.error.is_finite())?;
        let gain = Gain::of(&before, &trial);
        let gained_nothing =
            (self.was_lawful && gain.part < LITTLE) || (trial.error < SMALL && STALL * gain.factor < 1.0);
        self.stalls = if gained_nothing { self.stalls + 1 } else { 0 };
        self.was_lawful |= gain.is_lawful();
        self.gained_little |= gain.before < USEFUL && gain.part < 1.0 - LAWFUL;
        Some(gain)
    }
}

impl<L: Trials> Search<L> {
    /// The ladders of an order: that of plain `f64`, and where its roundings are felt the others',
    /// too. What then serves is vouched for.
    pub(super) fn climb(&mut self, composition: Composition, coarsest: u64) {
        let climb = self.ladder(PLAIN.composed(composition), coarsest, RUNGS);
        if climb.gained_little && climb.finest.is_some_and(|finest| self.has_roundings(&finest)) {
            self.is_rough = true;
            let from = self.smooth(composition, coarsest);
            for other in self.others {
                self.ladder(other.composed(composition), from, MORE_RUNGS);
            }
        }
        if self.best().is_some() && !self.is_vouched_for() {
            self.vouch();
        }
    }

    fn ladder(&mut self, scheme: Scheme, coarsest: u64, rungs: usize) -> Climb {
        let (mut steps, mut climb) = (coarsest, Climb::default());
        for _ in 0..rungs {
            if self.cost(scheme, steps as f64) >= self.least_cost() {
                break;
            }
            // Where a leap takes too long, the next rung may not.
            let next = climb.finest.map_or(steps, |before| 2 * before.steps);
            let mut rungs = [steps, next].into_iter();
            let Some(trial) = rungs.find_map(|steps| self.trial(scheme, steps, SHARE)) else { break };
            let gain = climb.add(trial);
            if trial.error <= ENOUGH * self.tolerance {
                break;
            }
            if climb.stalls >= STALLS {
                // So near, where another rung may do by luck, the price of what serves is the only
                // end.
                let is_near = trial.error <= NEAR * self.tolerance && self.best().is_some();
                if !is_near && self.has_roundings(&trial) {
                    break;
                }
                // A stiff motion: steps of either size meet poles of the map, which finer ones will
                // not.
                climb.stalls = 0;
            }
            steps = 2 * trial.steps;
            if let Some(gain) = gain.filter(|gain| trial.error < SMALL && gain.factor > 2.0) {
                let enough = Self::by_law(&trial, 0.9 * ENOUGH * self.tolerance);
                if self.cost(scheme, enough) > SURELY * self.least_cost() {
                    break;
                }
                // Where the law is seen to hold, there is no need of the rungs between.
                if gain.is_lawful() {
                    steps = (enough.ceil() as u64).clamp(trial.steps + 1, trial.steps.saturating_mul(LEAP));
                }
            }
        }
        climb
    }

    /// Whether a trial errs by its roundings rather than by its order: double-double, which has
    /// none, errs less.
    fn has_roundings(&mut self, trial: &Setting) -> bool {
        let wide = WIDE.composed(trial.scheme.composition);
        let other = if trial.scheme == wide { None } else { self.trial(wide, trial.steps, SHARE) };
        other.is_none_or(|other| other.error < STALL * trial.error)
    }

    /// The finest steps of an order at which the errors of plain `f64` still fell by the law.
    fn smooth(&self, composition: Composition, coarsest: u64) -> u64 {
        let scheme = PLAIN.composed(composition);
        let mut plain: Vec<&Setting> = self.tried.iter().filter(|trial| trial.scheme == scheme).collect();
        plain.sort_by_key(|trial| trial.steps);
        let is_lawful = |pair: &&[&Setting]| Gain::of(pair[0], pair[1]).part > 1.0 - LAWFUL;
        plain.windows(2).filter(is_lawful).map(|pair| pair[1].steps).max().unwrap_or(coarsest)
    }
}
