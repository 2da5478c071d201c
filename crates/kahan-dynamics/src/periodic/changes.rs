//! Finds the bifurcations within one step of a continuation: folds, and multipliers that cross the
//! unit circle.

use std::fmt;
use std::iter::repeat_n;

use super::branch::{BranchPosition, Curve};
use super::cycle::{PeriodicPoint, size};

/// A bifurcation on a branch of cycles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum BranchChange {
    /// The parameter reverses its direction at a fold, and a real multiplier passes through 1.
    Fold,
    /// A cycle of a flow merges with a cycle of half the period, and the branch ends.
    Halved,
    /// A cycle of a flow shrinks to a steady state at a Hopf point, and the branch ends.
    Hopf,
    /// A real multiplier passes through 1 without a fold.
    ThroughOne,
    /// A real multiplier passes through −1, and the period doubles.
    ThroughMinusOne,
    /// A pair of complex multipliers crosses the unit circle.
    ThroughCircle,
}

impl BranchChange {
    /// Returns whether a branch ends at this bifurcation.
    #[must_use]
    pub fn is_end(self) -> bool {
        matches!(self, Self::Halved | Self::Hopf)
    }
}

impl fmt::Display for BranchChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Fold => "fold, two cycles meet",
            Self::Halved => {
                "the branch ends on a cycle of half the period, which doubles there; follow that one from here on"
            }
            Self::Hopf => "the branch ends on a steady state, a Hopf point of the field",
            Self::ThroughOne => "a multiplier goes through 1",
            Self::ThroughMinusOne => "a multiplier goes through -1, the period may double",
            Self::ThroughCircle => "a pair of multipliers goes through the unit circle",
        })
    }
}

/// A bifurcation and its parameter value.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ChangePoint {
    /// The kind of bifurcation.
    pub change: BranchChange,
    /// The parameter value.
    pub parameter: f64,
}

/// One continuation step: the solution curve from `place` on, up to `length` along `tangent`.
pub(super) struct BranchSegment<'a, C> {
    pub(super) arc: &'a C,
    pub(super) place: &'a BranchPosition,
    pub(super) tangent: &'a BranchPosition,
    pub(super) length: f64,
}

/// A sample within a step: the direction of the parameter, and the cycle.
struct SegmentPoint {
    at: f64,
    /// Whether the parameter moves towards the end of its range.
    goes_ahead: bool,
    cycle: PeriodicPoint,
}

impl SegmentPoint {
    fn new(at: f64, tangent: &BranchPosition, cycle: PeriodicPoint) -> Self {
        SegmentPoint { at, goes_ahead: tangent[tangent.len() - 1] > 0.0, cycle }
    }

    /// Counts the multipliers outside the unit circle that are real above 1, real below −1, and
    /// complex.
    fn outside_by_kind(&self) -> [isize; 3] {
        /// A multiplier with a smaller imaginary part is treated as real, because rounding can make
        /// two nearly equal real multipliers complex.
        const REAL_MULTIPLIER_TOLERANCE: f64 = 1e-3;

        let mut counts = [0; 3];
        for one in &self.cycle.multipliers[..self.cycle.outside()] {
            let kind = match one.im.abs() > REAL_MULTIPLIER_TOLERANCE {
                true => 2,
                false => usize::from(one.re < 0.0),
            };
            counts[kind] += 1;
        }
        counts
    }
}

impl<C: Curve> BranchSegment<'_, C> {
    /// Returns the bifurcations within the step from the cycle `first` to the cycle `last`, each
    /// with its distance along the step.
    pub(super) fn changes(
        &self,
        first: &PeriodicPoint,
        (tangent, last): (&BranchPosition, &PeriodicPoint),
    ) -> Vec<(f64, ChangePoint)> {
        let ends = [
            SegmentPoint::new(0.0, self.tangent, first.clone()),
            SegmentPoint::new(self.length, tangent, last.clone()),
        ];
        let mut turns = Vec::new();
        // One bifurcation takes about 40 bisections. The limit ends searches in rounding noise.
        let mut halvings = 400;
        self.search([&ends[0], &ends[1]], &mut halvings, &mut turns);
        turns
    }

    /// Bisects between two samples until each interval holds at most one bifurcation.
    fn search(
        &self,
        [low, high]: [&SegmentPoint; 2],
        halvings: &mut usize,
        turns: &mut Vec<(f64, ChangePoint)>,
    ) {
        /// The relative distance below which bifurcations are treated as simultaneous.
        const AT_ONCE: f64 = 1e-12;

        let turns_back = low.goes_ahead != high.goes_ahead;
        let (before, after) = (low.outside_by_kind(), high.outside_by_kind());
        let [one, minus_one, pairs] = [0, 1, 2].map(|kind| after[kind] - before[kind]);
        match (turns_back, one.abs(), minus_one.abs(), pairs.abs()) {
            (false, 0, 0, 0) => return,
            (true, 1, 0, 0) => return turns.push(self.fold([low, high])),
            (false, 1, 0, 0) => return turns.push(self.crossing(BranchChange::ThroughOne, [low, high])),
            (false, 0, 1, 0) => return turns.push(self.crossing(BranchChange::ThroughMinusOne, [low, high])),
            (false, 0, 0, 2) => return turns.push(self.crossing(BranchChange::ThroughCircle, [low, high])),
            _ => {}
        }
        let is_wide = high.at - low.at > AT_ONCE * self.length && *halvings > 0;
        if let Some(middle) = is_wide.then(|| self.segment_point(0.5 * (low.at + high.at))).flatten() {
            *halvings -= 1;
            self.search([low, &middle], halvings, turns);
            self.search([&middle, high], halvings, turns);
            return;
        }
        let there = self.at(high.at);
        let parameter = self.arc.parameter(there.as_ref().unwrap_or(self.place));
        let mut tell = |change, times: isize| {
            turns.extend(repeat_n((high.at, ChangePoint { change, parameter }), times.unsigned_abs()));
        };
        // Two real multipliers outside the unit circle may become a complex pair, or a pair may
        // become real. `met` counts these multipliers, because they do not cross the circle.
        let met = |real: isize| if real.signum() == -pairs.signum() { real } else { 0 };
        tell(self.turning_back(there.as_ref()), isize::from(turns_back));
        tell(BranchChange::ThroughOne, ((one - met(one)).abs() - isize::from(turns_back)).max(0));
        tell(BranchChange::ThroughMinusOne, minus_one - met(minus_one));
        tell(BranchChange::ThroughCircle, (pairs + met(one) + met(minus_one)) / 2);
    }

    /// Returns the position at a distance along the step. A negative distance goes backwards.
    pub(super) fn at(&self, along: f64) -> Option<BranchPosition> {
        self.arc.step(self.place, self.tangent, along)
    }

    /// Finds the position between `ends` at which the scaled parameter is `value`.
    pub(super) fn position_at(
        &self,
        value: f64,
        ends: [(f64, &BranchPosition); 2],
    ) -> Option<BranchPosition> {
        let parameter = |place: &BranchPosition| place[place.len() - 1];
        let [mut low, mut high] = ends.map(|(at, place)| (at, parameter(place)));
        let mut near = ends[0].1.clone();
        for _ in 0..3 {
            let at = low.0 + (high.0 - low.0) * (value - low.1) / (high.1 - low.1);
            near = self.at(at)?;
            let there = (at, parameter(&near));
            let is_before = (there.1 < value) == (low.1 < high.1);
            *if is_before { &mut low } else { &mut high } = there;
        }
        let last = near.len() - 1;
        near[last] = value;
        let mut across = BranchPosition::zeros(near.len());
        across[last] = 1.0;
        self.arc.corrected(near, &across)
    }

    fn segment_point(&self, at: f64) -> Option<SegmentPoint> {
        let place = self.at(at)?;
        Some(SegmentPoint::new(
            at,
            &self.arc.tangent(&place, self.tangent)?,
            self.arc.classified(&place).cycle,
        ))
    }

    fn fold(&self, [low, high]: [&SegmentPoint; 2]) -> (f64, ChangePoint) {
        let is_before = |there: &BranchPosition| {
            let tangent = self.arc.tangent(there, self.tangent);
            tangent.is_none_or(|tangent| (tangent[tangent.len() - 1] > 0.0) == low.goes_ahead)
        };
        let (at, parameter) = self.bisect([low.at, high.at], is_before);
        (at, ChangePoint { change: self.turning_back(self.at(at).as_ref()), parameter })
    }

    fn turning_back(&self, there: Option<&BranchPosition>) -> BranchChange {
        there.map_or(BranchChange::Fold, |there| self.arc.turning_back(there))
    }

    /// Locates the crossing of the unit circle by a multiplier or a complex pair.
    fn crossing(&self, change: BranchChange, [low, high]: [&SegmentPoint; 2]) -> (f64, ChangePoint) {
        let (inner, outer) =
            if low.cycle.outside() < high.cycle.outside() { (low, high) } else { (high, low) };
        // Multipliers are sorted by decreasing modulus, so the last one outside crosses the circle.
        let index = outer.cycle.outside() - 1;
        let size_of = |cycle: &PeriodicPoint| size(&cycle.multipliers[index]);
        let size_at = |there: &BranchPosition| size_of(&self.arc.classified(there).cycle);
        let is_inside = |size: f64| size < 1.0 - inner.cycle.margin(index);
        // The multiplier at `inner` may be too near the unit circle to be surely inside. Then the
        // position `behind` is tried, which is farther from `outer`.
        let behind = inner.at + self.length * (inner.at - outer.at).signum();
        let (begin, bound) = if is_inside(size_of(&inner.cycle)) {
            (inner.at, 1.0)
        } else if self.at(behind).is_some_and(|there| is_inside(size_at(&there))) {
            (behind, 1.0)
        } else {
            // At no known position is the multiplier surely inside the circle. The search then
            // finds where the modulus exceeds 1 by the error margin.
            (inner.at, 1.0 + inner.cycle.margin(index))
        };
        let (at, parameter) = self.bisect([begin, outer.at], |there| size_at(there) <= bound);
        (at, ChangePoint { change, parameter })
    }

    /// Bisects for the last position at which `is_before` holds. Returns its distance along the
    /// step, and the parameter there.
    fn bisect(
        &self,
        [mut before, mut behind]: [f64; 2],
        is_before: impl Fn(&BranchPosition) -> bool,
    ) -> (f64, f64) {
        let mut found = (before, self.arc.parameter(self.place));
        for _ in 0..48 {
            let middle = 0.5 * (before + behind);
            let Some(there) = self.at(middle) else { break };
            if is_before(&there) {
                before = middle;
            } else {
                behind = middle;
            }
            found = (middle, self.arc.parameter(&there));
        }
        found
    }
}
