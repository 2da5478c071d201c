//! Checks the flow by an independent orbit.
//!
//! The distance of an orbit in `Dd` from the flow must be well below the tolerance. Otherwise the
//! flow may have large rounding errors. The orbit has the order that needs the fewest stages for
//! this accuracy.

use std::cmp::Reverse;

use kahan_core::Composition;

use super::super::{Scheme, Setting};
use super::{
    EQUAL_ERROR_RATIO, PHASE_LOSS_ERROR, PLAIN_DOUBLE_DOUBLE, REFERENCE_ACCURACY_FACTOR, Search, Trials,
};

const VOUCHERS: usize = 16;

impl<L: Trials> Search<L> {
    /// Searches for an orbit in `Dd` that agrees with the flow. Both are then accurate.
    pub(super) fn confirm(&mut self) {
        let wanted = self.tolerance / REFERENCE_ACCURACY_FACTOR;
        for _ in 0..VOUCHERS {
            let next = Composition::BEST.into_iter().rev().filter_map(|order| {
                Some((PLAIN_DOUBLE_DOUBLE.composed(order), self.steps_to(order, wanted)?))
            });
            let stages = |(scheme, steps): &(Scheme, u64)| *steps as f64 * scheme.composition.stages() as f64;
            let Some((scheme, steps)) = next.min_by(|a, b| stages(a).total_cmp(&stages(b))) else {
                // No order comes closer to the flow with more steps, so the flow has large rounding
                // errors.
                self.is_rough = true;
                return;
            };
            if self.trial(scheme, steps, 1.0).is_none_or(|trial| trial.error <= wanted) {
                return;
            }
        }
    }

    /// Predicts from earlier trials how many steps reach the error `wanted`, by the law error ∝
    /// ε^order. Returns `None` if trials in `Dd` with more steps come no closer to the flow.
    fn steps_to(&self, composition: Composition, wanted: f64) -> Option<u64> {
        let of_order = || self.tried.iter().filter(|trial| trial.scheme.composition == composition);
        let by_law = |trial: &Setting| Self::steps_by_order_law(trial, 0.7 * wanted);
        let mut wide: Vec<&Setting> =
            of_order().filter(|trial| trial.scheme == PLAIN_DOUBLE_DOUBLE.composed(composition)).collect();
        wide.sort_by_key(|trial| Reverse(trial.steps));
        let Some(finest) = wide.first() else {
            let useful = of_order().filter(|trial| trial.error < PHASE_LOSS_ERROR.max(self.tolerance));
            return useful
                .min_by(|a, b| a.error.total_cmp(&b.error))
                .map(|best| by_law(best).ceil().max(1.0) as u64);
        };
        let stalls = wide.windows(2).take_while(|pair| {
            pair[0].error < PHASE_LOSS_ERROR && pair[0].error > EQUAL_ERROR_RATIO * pair[1].error
        });
        if stalls.count() > 1 {
            return None;
        }
        let steps = finest.steps as f64;
        // Errors above `PHASE_LOSS_ERROR` do not follow the law error ∝ ε^order, so the number of
        // steps is doubled.
        let next = if finest.error < PHASE_LOSS_ERROR {
            by_law(finest).clamp(1.3 * steps, 4.0 * steps)
        } else {
            2.0 * steps
        };
        Some(next.ceil() as u64)
    }
}
