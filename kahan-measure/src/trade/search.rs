//! Which settings to measure: as few as make the answer clear.
//!
//! For each kind a ladder, the number of steps doubled from the coarsest sensible one, until it
//! meets the tolerance, or costs more than a setting that does (then so does everything finer), or
//! is sure to by the law error ∝ ε^order, or gains nothing any more. Then between the last rung
//! that fails and the first that would be too dear, by the same law.

use super::kind::{Kind, ORDERS, ScalarKind};
use super::study::Study;

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
/// or that it will take this part of the time that is left.
const SHARE: f64 = 0.3;

/// Whether the errors on a ladder fell as the order has it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Roundings {
    /// They did.
    Unseen,
    /// They fell less: there were roundings in them, which compensation makes fewer.
    Felt,
}

impl Study<'_> {
    /// Measures until the answer is clear; `coarsest` is the least number of steps over the
    /// horizon.
    pub(super) fn search(&mut self, coarsest: u64) {
        let plain = |scalar, order| Kind { scalar, order, compensated: false };
        // First something that does, which ends the ladders of others early: high orders before low
        // ones.
        let first = self.with_and_without(plain(ScalarKind::F64, 8), coarsest);
        if self.best().is_none() {
            self.ladder(plain(ScalarKind::Dd, 8), coarsest);
        }
        // Where the roundings of f64 are felt, ten times the price for none can be the better
        // bargain.
        let mut wide: Vec<u32> = if first == Roundings::Felt { vec![8] } else { Vec::new() };
        for scalar in [ScalarKind::F64, ScalarKind::F32, ScalarKind::F32ThroughF64] {
            for order in ORDERS.into_iter().rev() {
                // No point is nearer to a trajectory than its own rounding: one order shows how
                // near that is.
                let is_hopeless = self.tolerance < scalar.unit() / 8.0;
                let is_known = scalar == ScalarKind::F64 && order == 8;
                if !(is_known || is_hopeless && order < 8) {
                    let roundings = self.with_and_without(plain(scalar, order), coarsest);
                    if scalar == ScalarKind::F64 && roundings == Roundings::Felt {
                        wide.push(order);
                    }
                }
            }
        }
        let only_dd = self.best().is_none_or(|best| self.settings[best].kind.scalar == ScalarKind::Dd);
        for order in ORDERS.into_iter().rev() {
            let kind = plain(ScalarKind::Dd, order);
            if (only_dd || wide.contains(&order)) && self.settings.iter().all(|known| known.kind != kind) {
                self.ladder(kind, coarsest);
            }
        }
        for kind in Kind::all() {
            self.refine(kind);
        }
        if self.is_uneven() {
            for scalar in [ScalarKind::F64, ScalarKind::F32] {
                for order in ORDERS.into_iter().rev() {
                    self.scan(plain(scalar, order), coarsest);
                }
            }
        }
    }

    /// Whether finer steps were seen to err more, and not for roundings: where a motion is stiff,
    /// steps of some sizes meet poles of the map, and there is more than one stretch of sizes that
    /// serve.
    fn is_uneven(&self) -> bool {
        let doubles = || {
            let plain = self.settings.iter().filter(|setting| !setting.kind.compensated);
            plain.filter(|setting| setting.kind.scalar == ScalarKind::F64)
        };
        doubles().any(|coarse| {
            let error = coarse.error(self.need);
            let finer = doubles().filter(|fine| fine.kind == coarse.kind && fine.steps > coarse.steps);
            (UNEVEN..0.1).contains(&error)
                && finer.into_iter().any(|fine| error < STALL * fine.error(self.need))
        })
    }

    /// Tries all sizes of steps, as far as they cost less than what is known to do, and there is
    /// time.
    fn scan(&mut self, kind: Kind, coarsest: u64) {
        let mut steps = coarsest;
        while CLOSE * self.cost(kind, steps) < self.least_cost()
            && !self.takes_more_than(SHARE, kind, steps as f64)
            && self.error(kind, steps).is_some()
        {
            steps = (GRID * steps as f64).ceil() as u64;
        }
    }

    /// The plain kind, and the compensated one where the plain one's errors show its roundings.
    fn with_and_without(&mut self, kind: Kind, coarsest: u64) -> Roundings {
        let roundings = self.ladder(kind, coarsest);
        if roundings == Roundings::Felt && self.tolerance >= kind.scalar.unit() / 8.0 {
            self.ladder(Kind { compensated: true, ..kind }, coarsest);
        }
        roundings
    }

    fn ladder(&mut self, kind: Kind, coarsest: u64) -> Roundings {
        let (mut before, mut stalls) = (f64::INFINITY, 0);
        let (mut roundings, mut has_gained) = (Roundings::Unseen, false);
        for rung in 0..RUNGS {
            let steps = coarsest << rung;
            if self.cost(kind, steps) >= self.least_cost() {
                return roundings;
            }
            let Some(error) = self.error(kind, steps) else { return roundings };
            // What the step itself leaves falls by 2^order.
            if before < 0.01 && error > 4.0 * before * 0.5_f64.powi(kind.order as i32) {
                roundings = Roundings::Felt;
            }
            if error <= self.tolerance {
                return roundings;
            }
            stalls = if error < 0.1 && error > STALL * before { stalls + 1 } else { 0 };
            has_gained |= before.is_finite() && error < 0.5 * before;
            if stalls >= if has_gained { 2 } else { PATIENCE } {
                if self.has_roundings(kind, steps, error) {
                    self.stalled.push(kind);
                    return roundings;
                }
                // A stiff motion: coarse steps meet poles of the map, which finer ones will not.
                stalls = 0;
            }
            // Two rungs make sure that the law holds already.
            if error < 0.1 && error < 0.5 * before && before.is_finite() {
                let gain = (error / self.tolerance).powf(1.0 / f64::from(kind.order));
                let enough = steps as f64 * gain;
                if self.cost(kind, 1) * enough > SURELY * self.least_cost() {
                    return roundings;
                }
                if self.takes_more_than(SHARE, kind, enough) {
                    self.skip(kind, steps.saturating_mul(2));
                    return roundings;
                }
            }
            before = error;
        }
        roundings
    }

    /// Whether so many steps err by their roundings rather than by their order: double-double,
    /// which has none, errs less.
    fn has_roundings(&mut self, kind: Kind, steps: u64, error: f64) -> bool {
        let wide = Kind { scalar: ScalarKind::Dd, compensated: false, ..kind };
        kind == wide
            || self.takes_more_than(SHARE, wide, steps as f64)
            || self.error(wide, steps).is_none_or(|other| other < STALL * error)
    }

    /// Looks for fewer steps that still do.
    fn refine(&mut self, kind: Kind) {
        for _ in 0..TRIALS {
            let Some((low, high, error)) = self.gap(kind) else { return };
            let (low, high) = (low as f64, high);
            if high / low < CLOSE {
                return;
            }
            // error ∝ steps^(−order), with a little to spare.
            let gain = (error / self.tolerance).powf(1.0 / f64::from(kind.order));
            let guess = if gain.is_finite() { 1.01 * low * gain } else { (low * high).sqrt() };
            if guess >= high * 1.2 {
                return;
            }
            // Of few steps the next number may be the one.
            let steps = (guess.max(low * 1.02).min(high * 0.98).round() as u64).max(low as u64 + 1);
            if steps as f64 <= low || steps as f64 >= high || self.error(kind, steps).is_none() {
                return;
            }
        }
    }

    /// Between the finest setting of a kind that fails and what would be as dear as the best: steps
    /// and their error.
    fn gap(&self, kind: Kind) -> Option<(u64, f64, f64)> {
        let dearest = self.least_cost() * self.horizon / self.clock.nanoseconds(kind);
        if !dearest.is_finite() {
            return None;
        }
        let fails = self.settings.iter().filter(|setting| setting.kind == kind);
        let fails = fails.filter(|setting| setting.error(self.need) > self.tolerance);
        let fails = fails.filter(|setting| (setting.steps as f64) < dearest);
        let last = fails.max_by_key(|setting| setting.steps)?;
        Some((last.steps, dearest, last.error(self.need)))
    }
}
