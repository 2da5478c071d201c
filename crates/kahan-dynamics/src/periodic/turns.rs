//! What happens within a stride along a branch: where it turns back, and which multipliers go
//! through the unit circle.

use std::fmt;
use std::iter::repeat_n;

use super::branch::{Curve, Place};
use super::cycle::{PeriodicPoint, size};

/// What happens between two cycles of a branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Change {
    /// The branch turns back: two cycles meet, and a real multiplier goes through 1.
    Fold,
    /// The points of a cycle of the flow come together in pairs: the branch ends on a cycle of half
    /// the period, where that one's period doubles.
    Halved,
    /// A cycle of the flow shrinks to a steady state, where the branch ends.
    Hopf,
    /// A real multiplier goes through 1, and the branch does not turn back.
    ThroughOne,
    /// A real multiplier goes through −1: cycles of twice the period may begin.
    ThroughMinusOne,
    /// A pair of complex multipliers goes through the unit circle.
    ThroughCircle,
}

impl Change {
    /// Returns whether a branch ends there.
    #[must_use]
    pub fn is_end(self) -> bool {
        matches!(self, Self::Halved | Self::Hopf)
    }
}

/// What it means, in words.
impl fmt::Display for Change {
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

/// A change, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Turn {
    /// What happens.
    pub change: Change,
    /// The parameter there.
    pub parameter: f64,
}

/// A way along the branch, ahead from a place.
pub(super) struct Stride<'a, C> {
    pub(super) arc: &'a C,
    pub(super) place: &'a Place,
    pub(super) tangent: &'a Place,
    pub(super) length: f64,
}

/// What is known of a cycle on a stride.
struct Post {
    /// How far along the stride.
    at: f64,
    /// Whether the parameter goes on towards the end of its range.
    goes_ahead: bool,
    cycle: PeriodicPoint,
}

impl Post {
    fn new(at: f64, tangent: &Place, cycle: PeriodicPoint) -> Self {
        Post { at, goes_ahead: tangent[tangent.len() - 1] > 0.0, cycle }
    }

    /// How many multipliers outside the circle are real and above 1, real and below −1, complex.
    fn outside_by_kind(&self) -> [isize; 3] {
        /// Two that are nearly one may be complex by rounding.
        const REAL: f64 = 1e-3;

        let mut counts = [0; 3];
        for one in &self.cycle.multipliers[..self.cycle.outside()] {
            let kind = match one.im.abs() > REAL {
                true => 2,
                false => usize::from(one.re < 0.0),
            };
            counts[kind] += 1;
        }
        counts
    }
}

impl<C: Curve> Stride<'_, C> {
    /// Returns the changes between the first cycle and the last one in order, each with its distance
    /// along the stride.
    pub(super) fn turns(
        &self,
        first: &PeriodicPoint,
        (tangent, last): (&Place, &PeriodicPoint),
    ) -> Vec<(f64, Turn)> {
        let ends =
            [Post::new(0.0, self.tangent, first.clone()), Post::new(self.length, tangent, last.clone())];
        let mut turns = Vec::new();
        // A change takes some forty; more would look for order in rounding.
        let mut halvings = 400;
        self.search([&ends[0], &ends[1]], &mut halvings, &mut turns);
        turns
    }

    /// Halves what lies between two posts, so many times at most, until each part holds one change
    /// at most.
    fn search(&self, [low, high]: [&Post; 2], halvings: &mut usize, turns: &mut Vec<(f64, Turn)>) {
        /// Of the stride: what is nearer to each other happens at once.
        const AT_ONCE: f64 = 1e-12;

        let turns_back = low.goes_ahead != high.goes_ahead;
        let (before, after) = (low.outside_by_kind(), high.outside_by_kind());
        let [one, minus_one, pairs] = [0, 1, 2].map(|kind| after[kind] - before[kind]);
        match (turns_back, one.abs(), minus_one.abs(), pairs.abs()) {
            (false, 0, 0, 0) => return,
            (true, 1, 0, 0) => return turns.push(self.fold([low, high])),
            (false, 1, 0, 0) => return turns.push(self.crossing(Change::ThroughOne, [low, high])),
            (false, 0, 1, 0) => return turns.push(self.crossing(Change::ThroughMinusOne, [low, high])),
            (false, 0, 0, 2) => return turns.push(self.crossing(Change::ThroughCircle, [low, high])),
            _ => {}
        }
        let is_wide = high.at - low.at > AT_ONCE * self.length && *halvings > 0;
        if let Some(middle) = is_wide.then(|| self.post(0.5 * (low.at + high.at))).flatten() {
            *halvings -= 1;
            self.search([low, &middle], halvings, turns);
            self.search([&middle, high], halvings, turns);
            return;
        }
        let there = self.at(high.at);
        let parameter = self.arc.parameter(there.as_ref().unwrap_or(self.place));
        let mut tell = |change, times: isize| {
            turns.extend(repeat_n((high.at, Turn { change, parameter }), times.unsigned_abs()));
        };
        // Where real multipliers meet outside the circle and become complex, none goes through it.
        let met = |real: isize| if real.signum() == -pairs.signum() { real } else { 0 };
        tell(self.turning_back(there.as_ref()), isize::from(turns_back));
        tell(Change::ThroughOne, ((one - met(one)).abs() - isize::from(turns_back)).max(0));
        tell(Change::ThroughMinusOne, minus_one - met(minus_one));
        tell(Change::ThroughCircle, (pairs + met(one) + met(minus_one)) / 2);
    }

    /// The place so far along, back if less than 0.
    pub(super) fn at(&self, along: f64) -> Option<Place> {
        self.arc.step(self.place, self.tangent, along)
    }

    /// The place with this value of the parameter, in units of the range, between two others.
    pub(super) fn place_with(&self, value: f64, ends: [(f64, &Place); 2]) -> Option<Place> {
        let parameter = |place: &Place| place[place.len() - 1];
        let [mut low, mut high] = ends.map(|(at, place)| (at, parameter(place)));
        let mut near = ends[0].1.clone();
        // Newton's method ends the search.
        for _ in 0..3 {
            let at = low.0 + (high.0 - low.0) * (value - low.1) / (high.1 - low.1);
            near = self.at(at)?;
            let there = (at, parameter(&near));
            let is_before = (there.1 < value) == (low.1 < high.1);
            *if is_before { &mut low } else { &mut high } = there;
        }
        let last = near.len() - 1;
        near[last] = value;
        let mut across = Place::zeros(near.len());
        across[last] = 1.0;
        self.arc.corrected(near, &across)
    }

    fn post(&self, at: f64) -> Option<Post> {
        let place = self.at(at)?;
        Some(Post::new(at, &self.arc.tangent(&place, self.tangent)?, self.arc.judged(&place).cycle))
    }

    /// Where the branch turns back between two posts.
    fn fold(&self, [low, high]: [&Post; 2]) -> (f64, Turn) {
        let is_before = |there: &Place| {
            let tangent = self.arc.tangent(there, self.tangent);
            tangent.is_none_or(|tangent| (tangent[tangent.len() - 1] > 0.0) == low.goes_ahead)
        };
        let (at, parameter) = self.halved([low.at, high.at], is_before);
        (at, Turn { change: self.turning_back(self.at(at).as_ref()), parameter })
    }

    /// Returns the change at a place where the branch turns back.
    fn turning_back(&self, there: Option<&Place>) -> Change {
        there.map_or(Change::Fold, |there| self.arc.turning_back(there))
    }

    /// Where a multiplier, or a pair, comes to lie outside the circle, or no longer does.
    fn crossing(&self, change: Change, [low, high]: [&Post; 2]) -> (f64, Turn) {
        let (inner, outer) =
            if low.cycle.outside() < high.cycle.outside() { (low, high) } else { (high, low) };
        // It is the smallest of those that lie outside.
        let index = outer.cycle.outside() - 1;
        let size_of = |cycle: &PeriodicPoint| size(&cycle.multipliers[index]);
        let size_at = |there: &Place| size_of(&self.arc.judged(there).cycle);
        let is_inside = |size: f64| size < 1.0 - inner.cycle.margin(index);
        // One that goes through the circle may be at it where it does not count as outside yet.
        let behind = inner.at + self.length * (inner.at - outer.at).signum();
        let (begin, bound) = if is_inside(size_of(&inner.cycle)) {
            (inner.at, 1.0)
        } else if self.at(behind).is_some_and(|there| is_inside(size_at(&there))) {
            (behind, 1.0)
        } else {
            // It stayed on the circle but for rounding, and leaves it with a root of the distance.
            (inner.at, 1.0 + inner.cycle.margin(index))
        };
        let (at, parameter) = self.halved([begin, outer.at], |there| size_at(there) <= bound);
        (at, Turn { change, parameter })
    }

    /// How far along a condition holds, of two parts of the stride, and the parameter there.
    fn halved(&self, [mut before, mut behind]: [f64; 2], is_before: impl Fn(&Place) -> bool) -> (f64, f64) {
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
