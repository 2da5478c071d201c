//! The order in which [`Scene::choose`](crate::Scene::choose) tries settings for a trajectory.
//!
//! From the highest order on, larger and larger numbers of steps are tried in plain `f64`
//! ([`refine_steps`](Search::refine_steps)). Rounding errors lead to other schemes, and may end
//! these trials. After the first success, an orbit in `Dd` checks the flow
//! ([`confirm`](super::confirm)). At the end [`Search::refine`] minimises the cost.

use kahan_core::Composition;

use super::{Precision, Scheme, Search, SearchParameters, Setting, Trials};

pub(super) const COUNTED: SearchParameters = SearchParameters {
    enough: 0.85,
    aim: 0.97,
    surplus: 1.0,
    leaps: true,
    surely: 1.5,
    // One trial takes less than half of the remaining time, so another trial can check the flow.
    share: 0.45,
};
/// A flow counts as accurate if some orbit in `Dd` differs from it by less than the tolerance
/// divided by this factor.
pub(in crate::scene) const REFERENCE_ACCURACY_FACTOR: f64 = 10.0;
/// If plain `f64` has large rounding errors, each alternative scheme has at most this many trials.
const MORE_RUNGS: usize = 5;

pub(in crate::scene) const PLAIN_DOUBLE: Scheme = Scheme::of(Precision::Double);
/// The scheme in `Dd`, where rounding errors are negligible.
pub(in crate::scene) const PLAIN_DOUBLE_DOUBLE: Scheme = Scheme::of(Precision::DoubleDouble);
/// The alternatives to plain `f64` for a single orbit. Schemes in `f32` are no alternative, because
/// their steps take as long as in `f64`.
pub(in crate::scene) const ALTERNATIVES_TO_DOUBLE: [Scheme; 2] =
    [PLAIN_DOUBLE_DOUBLE, PLAIN_DOUBLE.compensated()];
pub(in crate::scene) const OF_DOUBLE: [Scheme; 1] = [PLAIN_DOUBLE.compensated()];

#[derive(Clone, Copy, Debug)]
pub(in crate::scene) enum Verdict {
    /// The cheapest accepted setting, whose error includes the uncertainty of the flow.
    Choice(Setting),
    /// No setting meets the tolerance, or no trial confirms that the flow is accurate.
    None {
        least_error: f64,
        /// Whether rounding errors limited the accuracy of the flow or of some series of trials.
        is_rough: bool,
    },
}

impl<L: Trials> Search<L> {
    pub(in crate::scene) const fn counted(trials: L, tolerance: f64) -> Self {
        Self::new(trials, tolerance, COUNTED)
    }

    /// Tries settings until one is chosen or all fail. `coarsest` is the smallest number of steps
    /// over the whole time, and `others` are the alternatives to plain `f64`.
    pub(in crate::scene) fn run(&mut self, coarsest: u64, others: &[Scheme]) -> Verdict {
        // High orders come first, because an accepted setting shortens the trials of other orders.
        for composition in Composition::BEST.into_iter().rev() {
            self.refine_order(composition, coarsest, others);
            if self.best().is_none() && self.is_rough {
                // Lower orders need more steps, which increases rounding errors further.
                break;
            }
        }
        if self.is_confirmed() {
            for scheme in [&[PLAIN_DOUBLE], others].concat() {
                for composition in Composition::BEST.into_iter().rev() {
                    self.refine(scheme.composed(composition));
                }
            }
            if self.is_uneven(0.0) {
                for composition in Composition::BEST.into_iter().rev() {
                    self.scan(PLAIN_DOUBLE.composed(composition), coarsest);
                }
            }
        }
        let least_error = self.tried.iter().map(|trial| trial.error).fold(f64::INFINITY, f64::min);
        match self.best() {
            Some(best) if self.is_confirmed() => {
                let error = (best.error + least_error).min(self.tolerance);
                Verdict::Choice(Setting { error, ..best })
            }
            _ => Verdict::None { least_error, is_rough: self.is_rough },
        }
    }

    /// Tries larger and larger numbers of steps at one order in plain `f64`, and in other schemes
    /// if rounding errors matter. If a setting is accepted, an independent orbit in `Dd` checks the
    /// flow.
    fn refine_order(&mut self, composition: Composition, coarsest: u64, others: &[Scheme]) {
        let climb = self.refine_steps(PLAIN_DOUBLE.composed(composition), coarsest);
        if climb.has_felt_roundings() && climb.finest.is_some_and(|finest| self.has_roundings(&finest)) {
            self.is_rough = true;
            let from = self.steps_with_order_law(composition, coarsest);
            for other in others {
                self.refine_at_most(other.composed(composition), from, MORE_RUNGS);
            }
        }
        if self.best().is_some() && !self.is_confirmed() {
            self.confirm();
        }
    }

    /// Returns whether the flow agrees with an orbit in `Dd`, whose rounding errors are
    /// independent.
    fn is_confirmed(&self) -> bool {
        let vouches = |trial: &Setting| REFERENCE_ACCURACY_FACTOR * trial.error <= self.tolerance;
        self.tried.iter().any(|trial| trial.scheme.precision == Precision::DoubleDouble && vouches(trial))
    }
}
