//! Ladders: an order at more and more steps.
//!
//! In: a scheme and where to begin. Out: trials, until one serves, or costs more than a setting
//! that does, or is sure to by the law error ∝ ε^order, or two rungs in a row gain nothing; and
//! whether roundings were felt.

use kahan_core::Composition;

use super::{PLAIN, SMALL, STALL, Scheme, Search, Setting, Trials, WIDE};

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

/// The result of a ladder.
#[derive(Clone, Copy, Debug, Default)]
pub struct Climb {
    /// Whether some rung gained as the law has it.
    was_lawful: bool,
    /// Whether some rung gained less.
    gained_little: bool,
    /// How many rungs in a row gained nothing.
    stalls: u32,
    /// Whether it ended where rungs gained nothing, for their roundings.
    has_stalled: bool,
    /// The finest rung.
    pub(super) finest: Option<Setting>,
}

impl Climb {
    /// Whether errors fell less than the order has it: there may be roundings in them, which
    /// compensation makes fewer.
    #[must_use]
    pub const fn has_felt_roundings(&self) -> bool {
        self.gained_little
    }

    /// Whether the ladder ended where finer steps gain nothing, for their roundings.
    #[must_use]
    pub const fn has_stalled(&self) -> bool {
        self.has_stalled
    }

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
    /// Tries more and more steps of a scheme, from `coarsest` on, until some serve, or more cannot
    /// be the cheapest.
    pub fn ladder(&mut self, scheme: Scheme, coarsest: u64) -> Climb {
        self.rungs(scheme, coarsest, RUNGS)
    }

    pub(super) fn rungs(&mut self, scheme: Scheme, coarsest: u64, rungs: usize) -> Climb {
        let share = self.rules.share;
        let (mut steps, mut climb) = (coarsest, Climb::default());
        for _ in 0..rungs {
            if self.cost(scheme, steps as f64) >= self.least_cost() {
                break;
            }
            // Where a leap takes too long, the next rung may not.
            let next = climb.finest.map_or(steps, |before| before.steps.saturating_mul(2));
            let mut rungs = [steps, next].into_iter();
            let Some(trial) = rungs.find_map(|steps| self.trial(scheme, steps, share)) else { break };
            let gain = climb.add(trial);
            if trial.error <= self.enough() {
                break;
            }
            if climb.stalls >= STALLS {
                // So near, where another rung may do by luck, the price of what serves is the only
                // end.
                let is_near = trial.error <= NEAR * self.tolerance && self.best().is_some();
                if !is_near && self.has_roundings(&trial) {
                    climb.has_stalled = true;
                    break;
                }
                // A stiff motion: steps of either size meet poles of the map, which finer ones will
                // not.
                climb.stalls = 0;
            }
            // A setting of few bits has fewer or more steps than asked.
            steps = if self.rules.leaps { trial.steps } else { steps }.saturating_mul(2);
            if let Some(gain) = gain.filter(|gain| trial.error < SMALL && gain.factor > 2.0) {
                let enough = Self::by_law(&trial, 0.9 * self.rules.enough * self.tolerance);
                let is_dear = self.cost(scheme, enough) > self.rules.surely * self.least_cost();
                if is_dear || self.trials.gives_up(scheme, steps, enough, share) {
                    break;
                }
                // Where the law is seen to hold, there is no need of the rungs between.
                if self.rules.leaps && gain.is_lawful() {
                    steps = (enough.ceil() as u64).clamp(trial.steps + 1, trial.steps.saturating_mul(LEAP));
                }
            }
        }
        climb
    }

    /// Whether a trial errs by its roundings rather than by its order: double-double, which has
    /// none, errs less.
    pub(super) fn has_roundings(&mut self, trial: &Setting) -> bool {
        let wide = WIDE.composed(trial.scheme.composition);
        let other = if trial.scheme == wide { None } else { self.trial(wide, trial.steps, self.rules.share) };
        other.is_none_or(|other| other.error < STALL * trial.error)
    }

    /// The finest steps of an order at which the errors of plain `f64` still fell by the law.
    pub(super) fn smooth(&self, composition: Composition, coarsest: u64) -> u64 {
        let scheme = PLAIN.composed(composition);
        let mut plain: Vec<&Setting> = self.tried.iter().filter(|trial| trial.scheme == scheme).collect();
        plain.sort_by_key(|trial| trial.steps);
        let is_lawful = |pair: &&[&Setting]| Gain::of(pair[0], pair[1]).part > 1.0 - LAWFUL;
        plain.windows(2).filter(is_lawful).map(|pair| pair[1].steps).max().unwrap_or(coarsest)
    }
}
