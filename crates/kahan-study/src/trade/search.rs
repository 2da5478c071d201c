//! The order in which schemes are measured. Likely winners come first.

use kahan_core::Composition;
use kahan_dynamics::search::{Search, SearchParameters};
use kahan_dynamics::{Precision, Scheme};

use super::measure::SettingMeasurements;

pub(super) const MEASURED: SearchParameters =
    SearchParameters { enough: 1.0, aim: 1.0, surplus: 1.01, leaps: false, surely: 2.0, share: SHARE };
const SHARE: f64 = 0.3;
const UNEVEN_ERROR: f64 = 1e-11;

/// A search for the cheapest setting; `stalled` lists schemes whose errors have stopped falling.
pub(super) struct RefinementSearch<'a> {
    pub(super) search: Search<SettingMeasurements<'a>>,
    pub(super) tolerance: f64,
    pub(super) stalled: Vec<Scheme>,
}

impl RefinementSearch<'_> {
    /// Tries schemes, each with at least `coarsest` steps from the start to the horizon.
    pub(super) fn run(&mut self, coarsest: u64) {
        self.refine_order(coarsest);
        self.search.set_share(1.0);
        if self.search.best().is_none() {
            // No setting was found, so schemes that lacked time may use all the remaining time.
            for (scheme, _) in self.search.trials_mut().take_skipped() {
                self.refine_steps(scheme, coarsest);
            }
        }
        for scheme in Scheme::all() {
            self.search.refine(scheme);
        }
        self.search.set_share(SHARE);
        if self.search.is_uneven(UNEVEN_ERROR) {
            for precision in [Precision::Double, Precision::Single] {
                for composition in Composition::BEST.into_iter().rev() {
                    self.search.scan(Scheme::of(precision).composed(composition), coarsest);
                }
            }
        }
    }

    fn refine_order(&mut self, coarsest: u64) {
        let plain = |precision, composition| Scheme::of(precision).composed(composition);
        let [.., highest] = Composition::BEST;
        let first = self.with_and_without(plain(Precision::Double, highest), coarsest);
        if self.search.best().is_none() {
            self.refine_steps(plain(Precision::DoubleDouble, highest), coarsest);
        }
        // `wide` lists the orders to try in double-double: those at which `f64` rounding errors
        // matter.
        let mut wide = if first { vec![highest] } else { Vec::new() };
        for precision in [Precision::Double, Precision::Single, Precision::SingleThroughDouble] {
            for composition in Composition::BEST.into_iter().rev() {
                // If rounding errors exceed the tolerance, only the highest order is tried.
                let is_hopeless = self.tolerance < precision.unit() / 8.0;
                let is_known = precision == Precision::Double && composition == highest;
                if !(is_known || is_hopeless && composition != highest) {
                    let has_felt = self.with_and_without(plain(precision, composition), coarsest);
                    if precision == Precision::Double && has_felt {
                        wide.push(composition);
                    }
                }
            }
        }
        let best = self.search.best();
        let only_dd = best.is_none_or(|best| best.scheme().precision == Precision::DoubleDouble);
        for composition in Composition::BEST.into_iter().rev() {
            let scheme = plain(Precision::DoubleDouble, composition);
            if (only_dd || wide.contains(&composition)) && !self.search.has_tried(scheme) {
                self.refine_steps(scheme, coarsest);
            }
        }
    }

    /// Tries more and more steps of a scheme, and returns whether rounding errors matter. If they
    /// do, also tries the scheme with compensated summation.
    fn with_and_without(&mut self, scheme: Scheme, coarsest: u64) -> bool {
        let has_felt = self.refine_steps(scheme, coarsest);
        if has_felt && self.tolerance >= scheme.precision.unit() / 8.0 {
            self.refine_steps(scheme.compensated(), coarsest);
        }
        has_felt
    }

    /// Tries more and more steps of a scheme; returns whether rounding errors matter.
    fn refine_steps(&mut self, scheme: Scheme, coarsest: u64) -> bool {
        let climb = self.search.refine_steps(scheme, coarsest);
        if climb.has_stalled() {
            self.stalled.push(scheme);
        }
        climb.has_felt_roundings()
    }
}
