//! The order in which [`Scene::choose`](crate::Scene::choose) tries settings.
//!
//! In: a search. Out: its verdict. A ladder for each order, in plain `f64` first; a second method
//! for the flow that trials are compared with ([`vouch`](super::vouch)); then [`Search::refine`].

use kahan_core::Composition;

use super::{Precision, Rules, Scheme, Search, Setting, Trials};

/// The rules where operations are counted.
pub(super) const COUNTED: Rules = Rules {
    enough: 0.85,
    aim: 0.97,
    surplus: 1.0,
    leaps: true,
    surely: 1.5,
    // The trial that confirms the flow needs time, too.
    share: 0.45,
};
/// A trial in `Dd` confirms the reference flow if its error is smaller than the tolerance by this
/// factor: two independent methods then agree.
pub(in crate::scene) const VOUCHING: f64 = 10.0;
/// The most rungs of a ladder that begins where another felt roundings.
const MORE_RUNGS: usize = 5;

/// The numbers of the first trials, plain `f64`.
pub(in crate::scene) const PLAIN: Scheme = Scheme::of(Precision::Double);
/// `Dd`, whose roundings are never seen.
pub(in crate::scene) const WIDE: Scheme = Scheme::of(Precision::DoubleDouble);
/// Numbers for a single orbit besides plain `f64`. `f32` is left out, since its steps take as long.
pub(in crate::scene) const OTHERS: [Scheme; 2] = [WIDE, PLAIN.compensated()];
/// Those of them in `f64`.
pub(in crate::scene) const OF_DOUBLE: [Scheme; 1] = [PLAIN.compensated()];

/// The answer.
#[derive(Clone, Copy, Debug)]
pub(in crate::scene) enum Verdict {
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

impl<L: Trials> Search<L> {
    /// Makes the search of operations counted.
    pub(in crate::scene) const fn counted(trials: L, tolerance: f64) -> Self {
        Self::new(trials, tolerance, COUNTED)
    }

    /// Tries until the answer is clear; `coarsest` is the least number of steps over the horizon,
    /// `others` are the numbers that may be chosen besides plain `f64`.
    pub(in crate::scene) fn run(&mut self, coarsest: u64, others: &[Scheme]) -> Verdict {
        // High orders first: something that serves ends the ladders of others early.
        for composition in Composition::BEST.into_iter().rev() {
            self.climb(composition, coarsest, others);
            if self.best().is_none() && self.is_rough {
                // Finer steps round more often.
                break;
            }
        }
        if self.is_vouched_for() {
            for scheme in [&[PLAIN], others].concat() {
                for composition in Composition::BEST.into_iter().rev() {
                    self.refine(scheme.composed(composition));
                }
            }
            if self.is_uneven(0.0) {
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

    /// The ladders of an order: that of plain `f64`, and where its roundings are felt the others',
    /// too. What then serves is vouched for.
    fn climb(&mut self, composition: Composition, coarsest: u64, others: &[Scheme]) {
        let climb = self.ladder(PLAIN.composed(composition), coarsest);
        if climb.has_felt_roundings() && climb.finest.is_some_and(|finest| self.has_roundings(&finest)) {
            self.is_rough = true;
            let from = self.smooth(composition, coarsest);
            for other in others {
                self.rungs(other.composed(composition), from, MORE_RUNGS);
            }
        }
        if self.best().is_some() && !self.is_vouched_for() {
            self.vouch();
        }
    }

    /// Whether double-double, which has no roundings in common with anything, came as near to the
    /// flow as it must.
    fn is_vouched_for(&self) -> bool {
        let vouches = |trial: &Setting| VOUCHING * trial.error <= self.tolerance;
        self.tried.iter().any(|trial| trial.scheme.precision == Precision::DoubleDouble && vouches(trial))
    }
}
