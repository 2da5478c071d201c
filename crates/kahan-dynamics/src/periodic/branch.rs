//! Cycles as a parameter, or ε, changes: along the arc of the branch, so that it may turn back.

use std::ops::ControlFlow;

use kahan_core::nalgebra::{DMatrix, DVector};

use super::Parametric;
use super::cycle::PeriodicPoint;
use super::newton::{NOTHING, defect, least_norm, slope};
use super::turns::{Stride, Turn};
use super::unit::{self, InUnits, Unit};

/// A cycle on a branch.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BranchPoint {
    /// The value of what changes.
    pub parameter: f64,
    /// The cycle there.
    pub cycle: PeriodicPoint,
}

/// A branch of cycles.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Branch {
    /// In the order of the branch.
    pub points: Vec<BranchPoint>,
    /// Those within the range, in the same order.
    pub turns: Vec<Turn>,
    /// Whether it ended before the ends of the range: at a pole, where no cycle was found beyond,
    /// after twenty times as many steps as were asked for, or where `see` ended it.
    pub is_cut: bool,
}

/// A place on the branch: the points of the cycle in units of its first size, and behind them the
/// parameter in units of the range. Both are then measured together.
pub(super) type Place = DVector<f64>;

/// Follows a cycle at `from` towards `to`, in about so many steps, until the parameter leaves the
/// range between them.
///
/// `map` makes the map at a value of the parameter, and `see` is shown each cycle as it is found,
/// and may end the branch there. Between two cycles each change is found by halving the step; what
/// changes and changes back between them is not seen.
///
/// Cost: each step some decompositions as those of
/// [`periodic_point`](super::periodic_point()), and each change some hundred.
///
/// ```
/// use std::ops::ControlFlow;
///
/// use kahan_core::Dual;
/// use kahan_dynamics::periodic::{Change, branch, periodic_point};
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// Stands still at x² = a.
///     pub struct Fold { a }
///     xdot = a - x^2;
/// }
///
/// // At a, which changes, and a fixed ε.
/// let map = |a| Fold { a: Dual::coordinate(a, 0) }.at(Dual::from_value(0.1));
/// let cycle = periodic_point(&map(1.0), &[0.9], 1).unwrap();
/// let branch = branch(map, &cycle, [1.0, -1.0], 20, |_| ControlFlow::Continue(()));
/// assert_eq!(branch.turns[0].change, Change::Fold);
/// assert!(branch.turns[0].parameter.abs() < 1e-9);
/// ```
pub fn branch<M: Parametric>(
    map: impl Fn(f64) -> M,
    cycle: &PeriodicPoint,
    [from, to]: [f64; 2],
    steps: usize,
    mut see: impl FnMut(&BranchPoint) -> ControlFlow<()>,
) -> Branch {
    let length = to - from;
    let arc = Arc { unit: Unit::of(first_size(&map(from), cycle, length)), map, from, length };
    let points = cycle.points.iter().flatten().map(|x| x / arc.unit.length);
    let mut place: Place = DVector::from_vec(points.chain([0.0]).collect());
    let mut ahead = DVector::zeros(place.len());
    ahead[place.len() - 1] = 1.0;
    let mut branch = Branch { points: Vec::new(), turns: Vec::new(), is_cut: false };
    let Some(mut tangent) = arc.tangent(&place, &ahead) else {
        branch.is_cut = true;
        return branch;
    };
    let first = arc.judged(&place);
    branch.is_cut = see(&first).is_break();
    branch.points.push(first);
    let steps = steps.max(1);
    // Far from the origin points move faster than the parameter.
    let longest = |place: &Place| place.norm().max(1.0) / steps as f64;
    let mut stride = longest(&place);
    while !branch.is_cut && (0.0..=1.0).contains(&place[place.len() - 1]) {
        let step =
            arc.step(&place, &tangent, stride).and_then(|next| Some((arc.tangent(&next, &tangent)?, next)));
        let Some((next_tangent, next)) = step.filter(|(turned, _)| turned.dot(&tangent) > 0.5) else {
            stride /= 2.0;
            if stride < longest(&place) / 4096.0 {
                branch.is_cut = true;
                break;
            }
            continue;
        };
        let there = arc.judged(&next);
        branch.is_cut = see(&there).is_break();
        let before = &branch.points[branch.points.len() - 1].cycle;
        let whole = Stride { arc: &arc, place: &place, tangent: &tangent, length: stride };
        let turns = whole.turns(before, (&next_tangent, &there.cycle)).into_iter();
        branch.turns.extend(turns.filter(|turn| (from.min(to)..=from.max(to)).contains(&turn.parameter)));
        branch.points.push(there);
        (place, tangent) = (next, next_tangent);
        stride = (1.5 * stride).min(longest(&place));
        // A branch that winds ends somewhere.
        if branch.points.len() > 20 * steps {
            branch.is_cut = true;
            break;
        }
    }
    branch
}

/// What points on a branch are measured by: the size of the first cycle. Where that is 0, as is the
/// point it was found from, how far it moves with the parameter.
fn first_size<M: Parametric>(map: &M, cycle: &PeriodicPoint, length: f64) -> f64 {
    if cycle.size > 0.0 {
        return cycle.size;
    }
    let rates = cycle.points.iter().map(|x| unit::size(&map.by_parameter(x)));
    let moved = rates.fold(0.0, f64::max) * length.abs();
    if moved.is_finite() { moved } else { 0.0 }
}

/// The curve of cycles over the range.
pub(super) struct Arc<F> {
    map: F,
    unit: Unit,
    from: f64,
    length: f64,
}

impl<M: Parametric, F: Fn(f64) -> M> Arc<F> {
    pub(super) fn parameter(&self, place: &Place) -> f64 {
        self.from + self.length * place[place.len() - 1]
    }

    fn map(&self, place: &Place) -> InUnits<M> {
        InUnits { map: (self.map)(self.parameter(place)), unit: self.unit }
    }

    fn cycle(place: &Place) -> DVector<f64> {
        place.rows(0, place.len() - 1).into_owned()
    }

    pub(super) fn judged(&self, place: &Place) -> BranchPoint {
        let (map, cycle) = (self.map(place), Self::cycle(place));
        let residual = defect(&map, &cycle).map_or(f64::NAN, |gaps| gaps.amax());
        BranchPoint { parameter: self.parameter(place), cycle: PeriodicPoint::judged(&map, &cycle, residual) }
    }

    /// The derivative of the defect: with respect to the points, then the parameter.
    fn slope(&self, place: &Place) -> Option<DMatrix<f64>> {
        let (map, cycle) = (self.map(place), Self::cycle(place));
        let slope = slope(&map, &cycle);
        let columns = slope.ncols();
        let mut wide = slope.insert_column(columns, 0.0);
        let by_parameter = cycle.as_slice().chunks(map.dimension()).flat_map(|x| map.by_parameter(x));
        for (entry, rate) in wide.column_mut(columns).iter_mut().zip(by_parameter) {
            *entry = rate * self.length;
        }
        wide.iter().all(|entry| entry.is_finite()).then_some(wide)
    }

    /// The direction of the branch that is nearest to another one, of length 1.
    pub(super) fn tangent(&self, place: &Place, near: &Place) -> Option<Place> {
        let wide = self.slope(place)?;
        // What the derivative does to the other direction is taken out of it.
        let out = least_norm(wide.clone(), &(&wide * near))?;
        (near - out).try_normalize(1e-8)
    }

    /// The place on the branch a stride further on.
    pub(super) fn step(&self, place: &Place, tangent: &Place, stride: f64) -> Option<Place> {
        const ROUNDS: usize = 12;
        const CLOSED: f64 = 1e-12;

        let gaps_at = |there: &Place| defect(&self.map(there), &Self::cycle(there));
        let mut next = place + tangent * stride;
        for _ in 0..ROUNDS {
            let gaps = gaps_at(&next)?;
            // Across the direction, so that it does not slide back.
            let wide = self.slope(&next)?;
            let rows = wide.nrows();
            let mut square = wide.insert_row(rows, 0.0);
            square.set_row(rows, &tangent.transpose());
            let nearer = &next - least_norm(square, &gaps.push(0.0))?;
            if gaps.amax() <= CLOSED * next.amax().max(1.0) {
                // Double multipliers show a root of what is left.
                let is_nearer =
                    gaps.amax() > NOTHING && gaps_at(&nearer).is_some_and(|left| left.amax() < gaps.amax());
                return Some(if is_nearer { nearer } else { next });
            }
            next = nearer;
        }
        None
    }
}
