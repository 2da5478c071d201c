//! Which settings to measure: as few as make the answer clear.
//!
//! For each scheme a ladder, the number of steps doubled from the coarsest sensible one, until it
//! meets the tolerance, or costs more than a setting that does (then so does everything finer), or
//! is sure to by the law error ∝ ε^order, or gains nothing any more. Then between the last rung
//! that fails and the first that would be too dear, by the same law.

use kahan_core::Composition;
use kahan_dynamics::{Precision, Scheme};

use super::Measured;
use super::measure::Search;

/// A ladder ends where two rungs in a row gained less than this factor, below errors of a tenth
/// (above, trajectories have lost their phase, and the error says nothing).
const STALL: f64 = 0.7;
/// Where no rung has gained anything yet, it takes so many: a motion that grows from next to
/// nothing is small to begin with, whatever coarse steps make of it.
const PATIENCE: u32 = 6;
/// The most rungs of a ladder.
const RUNGS: u32 = 34;
/// Steps that differ by less than this factor are not told apart.
const CLOSE: f64 = 1.05;
/// Trials between two rungs.
const TRIALS: usize = 6;

/// Errors of `f64` above this are seldom roundings.
const UNEVEN: f64 = 1e-11;
/// Where errors fall unevenly, steps that differ by this factor are tried.
const GRID: f64 = 1.1;

/// A ladder is given up where the law says that its end will cost this factor more than what is
/// known to do,
const SURELY: f64 = 2.0;
/// or that it will take this part of the time that is left: others may take less.
pub(super) const SHARE: f64 = 0.3;

/// Whether the errors on a ladder fell as the order has it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Roundings {
    /// They did.
    Unseen,
    /// They fell less: there were roundings in them, which compensation makes fewer.
    Felt,
}

impl Search<'_> {
    /// Measures until the answer is clear; `coarsest` is the least number of steps over the
    /// horizon.
    pub(super) fn search(&mut self, coarsest: u64) {
        self.climb(coarsest);
        if self.best().is_none() {
            // No other takes less, so what was put off has all the time that is left.
            self.share = 1.0;
            for (scheme, _) in std::mem::take(&mut self.skipped) {
                self.ladder(scheme, coarsest);
            }
        }
        for scheme in Scheme::all() {
            self.refine(scheme);
        }
        if self.is_uneven() {
            for precision in [Precision::Double, Precision::Single] {
                for composition in Composition::BEST.into_iter().rev() {
                    self.scan(Scheme::of(precision).composed(composition), coarsest);
                }
            }
        }
    }

    /// The ladder of every scheme that may be the cheapest.
    fn climb(&mut self, coarsest: u64) {
        let plain = |precision, composition| Scheme::of(precision).composed(composition);
        let [.., highest] = Composition::BEST;
        // First something that does, which ends the ladders of others early: high orders before low
        // ones.
        let first = self.with_and_without(plain(Precision::Double, highest), coarsest);
        if self.best().is_none() {
            self.ladder(plain(Precision::DoubleDouble, highest), coarsest);
        }
        // Where the roundings of f64 are felt, ten times the price for none can be the better
        // bargain.
        let mut wide = if first == Roundings::Felt { vec![highest] } else { Vec::new() };
        for precision in [Precision::Double, Precision::Single, Precision::SingleThroughDouble] {
            for composition in Composition::BEST.into_iter().rev() {
                // No point is nearer to a trajectory than its own rounding: one order shows how
                // near that is.
                let is_hopeless = self.tolerance < precision.unit() / 8.0;
                let is_known = precision == Precision::Double && composition == highest;
                if !(is_known || is_hopeless && composition != highest) {
                    let roundings = self.with_and_without(plain(precision, composition), coarsest);
                    if precision == Precision::Double && roundings == Roundings::Felt {
                        wide.push(composition);
                    }
                }
            }
        }
        let only_dd = self
            .best()
            .is_none_or(|best| self.settings[best].setting.scheme().precision == Precision::DoubleDouble);
        for composition in Composition::BEST.into_iter().rev() {
            let scheme = plain(Precision::DoubleDouble, composition);
            if (only_dd || wide.contains(&composition))
                && self.settings.iter().all(|known| known.setting.scheme() != scheme)
            {
                self.ladder(scheme, coarsest);
            }
        }
    }

    /// Whether finer steps were seen to err more, and not for roundings: where a motion is stiff,
    /// steps of some sizes meet poles of the map, and there is more than one stretch of sizes that
    /// serve.
    fn is_uneven(&self) -> bool {
        let doubles = || {
            let schemes = self.settings.iter().map(|known| (known.setting.scheme(), known));
            schemes
                .filter(|(scheme, _)| *scheme == Scheme::of(Precision::Double).composed(scheme.composition))
        };
        doubles().any(|(scheme, coarse)| {
            let is_worse = |(other, fine): (Scheme, &Measured)| {
                other == scheme
                    && fine.setting.steps() > coarse.setting.steps()
                    && coarse.error() < STALL * fine.error()
            };
            (UNEVEN..0.1).contains(&coarse.error()) && doubles().any(is_worse)
        })
    }

    /// Tries all sizes of steps, as far as they cost less than what is known to do, and there is
    /// time.
    fn scan(&mut self, scheme: Scheme, coarsest: u64) {
        let mut steps = coarsest;
        while CLOSE * self.cost(scheme, steps) < self.least_cost()
            && !self.takes_too_long(scheme, steps as f64)
            && self.error(scheme, steps).is_some()
        {
            steps = (GRID * steps as f64).ceil() as u64;
        }
    }

    /// The plain scheme, and the compensated one where the plain one's errors show its roundings.
    fn with_and_without(&mut self, scheme: Scheme, coarsest: u64) -> Roundings {
        let roundings = self.ladder(scheme, coarsest);
        if roundings == Roundings::Felt && self.tolerance >= scheme.precision.unit() / 8.0 {
            self.ladder(scheme.compensated(), coarsest);
        }
        roundings
    }

    fn ladder(&mut self, scheme: Scheme, coarsest: u64) -> Roundings {
        let (mut before, mut stalls) = (f64::INFINITY, 0);
        let (mut roundings, mut has_gained) = (Roundings::Unseen, false);
        for rung in 0..RUNGS {
            let steps = coarsest << rung;
            if self.cost(scheme, steps) >= self.least_cost() {
                return roundings;
            }
            let Some(error) = self.error(scheme, steps) else { return roundings };
            // What the step itself leaves falls by 2^order.
            if before < 0.01 && error > 4.0 * before * 0.5_f64.powi(scheme.order() as i32) {
                roundings = Roundings::Felt;
            }
            if error <= self.tolerance {
                return roundings;
            }
            stalls = if error < 0.1 && error > STALL * before { stalls + 1 } else { 0 };
            has_gained |= before.is_finite() && error < 0.5 * before;
            if stalls >= if has_gained { 2 } else { PATIENCE } {
                if self.has_roundings(scheme, steps, error) {
                    self.stalled.push(scheme);
                    return roundings;
                }
                // A stiff motion: coarse steps meet poles of the map, which finer ones will not.
                stalls = 0;
            }
            // Two rungs make sure that the law holds already.
            if error < 0.1 && error < 0.5 * before && before.is_finite() {
                let gain = (error / self.tolerance).powf(1.0 / f64::from(scheme.order()));
                let enough = steps as f64 * gain;
                if self.cost(scheme, 1) * enough > SURELY * self.least_cost() {
                    return roundings;
                }
                if self.takes_too_long(scheme, enough) {
                    self.skip(scheme, steps.saturating_mul(2));
                    return roundings;
                }
            }
            before = error;
        }
        roundings
    }

    /// Whether so many steps err by their roundings rather than by their order: double-double,
    /// which has none, errs less.
    fn has_roundings(&mut self, scheme: Scheme, steps: u64, error: f64) -> bool {
        let wide = Scheme::of(Precision::DoubleDouble).composed(scheme.composition);
        scheme == wide
            || self.takes_too_long(wide, steps as f64)
            || self.error(wide, steps).is_none_or(|other| other < STALL * error)
    }

    /// Looks for fewer steps that still do.
    fn refine(&mut self, scheme: Scheme) {
        for _ in 0..TRIALS {
            let Some((low, high, error)) = self.gap(scheme) else { return };
            let (low, high) = (low as f64, high);
            if high / low < CLOSE {
                return;
            }
            // error ∝ steps^(−order), with a little to spare.
            let gain = (error / self.tolerance).powf(1.0 / f64::from(scheme.order()));
            let guess = if gain.is_finite() { 1.01 * low * gain } else { (low * high).sqrt() };
            if guess >= high * 1.2 {
                return;
            }
            // Of few steps the next number may be the one.
            let steps = (guess.max(low * 1.02).min(high * 0.98).round() as u64).max(low as u64 + 1);
            if steps as f64 <= low || steps as f64 >= high || self.error(scheme, steps).is_none() {
                return;
            }
        }
    }

    /// Between the finest setting of a scheme that fails and what would be as dear as the best:
    /// steps and their error.
    fn gap(&self, scheme: Scheme) -> Option<(u64, f64, f64)> {
        let dearest = self.least_cost() * self.scene.horizon() / self.prices.nanoseconds(scheme);
        if !dearest.is_finite() {
            return None;
        }
        let fails = self.settings.iter().filter(|setting| setting.setting.scheme() == scheme);
        let fails = fails.filter(|setting| setting.error() > self.tolerance);
        let fails = fails.filter(|setting| (setting.setting.steps() as f64) < dearest);
        let last = fails.max_by_key(|setting| setting.setting.steps())?;
        Some((last.setting.steps(), dearest, last.error()))
    }
}
