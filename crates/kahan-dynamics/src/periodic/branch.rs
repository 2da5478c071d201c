//! Pseudo-arclength continuation of cycles in a parameter or ε, also around folds.

use std::ops::ControlFlow;

use kahan_core::Scalar;
use kahan_core::nalgebra::{DMatrix, DVector};

use super::Parametric;
use super::changes::{BranchChange, BranchSegment, ChangePoint};
use super::cycle::PeriodicPoint;
use super::newton::{NEGLIGIBLE_RESIDUAL, defect, least_norm_solution, slope};
use super::unit::{self, LengthUnit, ScaledMap};

/// A cycle on a branch.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BranchPoint {
    /// The value of the parameter.
    pub parameter: f64,
    /// Half the time step.
    pub eps: f64,
    /// The cycle at this parameter value.
    pub cycle: PeriodicPoint,
    /// The reason why the branch has this point.
    pub mark: BranchPointKind,
}

impl BranchPoint {
    /// Returns the bifurcation at this point, if any.
    #[must_use]
    pub fn change(&self) -> Option<BranchChange> {
        if let BranchPointKind::Change(change) = self.mark { Some(change) } else { None }
    }
}

/// The reason why a branch has a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum BranchPointKind {
    /// A requested value of the parameter, with the index of the value.
    Asked(usize),
    /// A bifurcation.
    Change(BranchChange),
    /// An intermediate step of the continuation.
    Between,
}

/// A branch of cycles.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Branch {
    /// The points within the range, in the order of the branch.
    pub points: Vec<BranchPoint>,
    /// The bifurcations within the range, in the order of the branch.
    pub turns: Vec<ChangePoint>,
    /// Whether the branch ended inside the range: at a pole, where cycles merge, after 20 times the
    /// requested steps, by the callback, or because Newton's method failed.
    pub is_cut: bool,
}

/// A position on the branch. The coordinates of all points come first, divided by the size of the
/// first cycle. The last entry is the parameter's position in its range, from 0 to 1.
pub(super) type BranchPosition = DVector<f64>;

/// Follows a cycle from the parameter value `from` towards `to`, until the parameter leaves the
/// range.
///
/// The branch has a point at each of `steps + 1` equidistant values, again after a fold, and
/// intermediate points. `map` makes the map at a value of the parameter. `see` receives each cycle
/// and may end the branch. Bifurcations are located by bisection. Two bifurcations within one step
/// may cancel each other, and are then missed.
///
/// Each step takes a few decompositions, as in [`periodic_point`](super::periodic_point()), and
/// each bifurcation a few hundred.
///
/// ```
/// use std::ops::ControlFlow;
///
/// use kahan_core::Dual;
/// use kahan_dynamics::periodic::{BranchChange, branch, periodic_point};
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// A field with fixed points at x² = a.
///     pub struct Fold { a }
///     xdot = a - x^2;
/// }
///
/// // At a, which changes, and a fixed ε.
/// let map = |a| Fold { a: Dual::coordinate(a, 0) }.at(Dual::from_value(0.1));
/// let cycle = periodic_point(&map(1.0), &[0.9], 1).unwrap();
/// let branch = branch(map, &cycle, [1.0, -1.0], 20, |_| ControlFlow::Continue(()));
/// assert_eq!(branch.turns[0].change, BranchChange::Fold);
/// assert!(branch.turns[0].parameter.abs() < 1e-9);
/// ```
pub fn branch<M: Parametric>(
    map: impl Fn(f64) -> M,
    cycle: &PeriodicPoint,
    [from, to]: [f64; 2],
    steps: usize,
    see: impl FnMut(&BranchPoint) -> ControlFlow<()>,
) -> Branch {
    let length = to - from;
    let arc = CycleCurve { unit: LengthUnit::of(first_size(&map(from), cycle, length)), map, from, length };
    let points = cycle.points.iter().flatten().map(|x| x / arc.unit.length);
    let place = DVector::from_vec(points.chain([0.0]).collect());
    follow(&arc, place, steps, see)
}

pub(super) fn follow(
    arc: &impl Curve,
    mut place: BranchPosition,
    steps: usize,
    mut see: impl FnMut(&BranchPoint) -> ControlFlow<()>,
) -> Branch {
    let mut ahead = DVector::zeros(place.len());
    ahead[place.len() - 1] = 1.0;
    let steps = steps.max(1);
    let mut branch = Branch { points: Vec::new(), turns: Vec::new(), is_cut: true };
    let Some(mut tangent) = arc.tangent(&place, &ahead) else { return branch };
    let mut add = |branch: &mut Branch, place: &BranchPosition, mark: BranchPointKind| {
        let point = BranchPoint { mark, ..arc.classified(place) };
        let is_ended = see(&point).is_break();
        branch.points.push(point);
        is_ended
    };
    if add(&mut branch, &place, BranchPointKind::Asked(0)) {
        return branch;
    }
    // Large positions change faster than the parameter, so steps grow with `place.norm()`.
    let longest = |place: &BranchPosition| place.norm().max(1.0) / steps as f64;
    let (mut stride, mut strides) = (longest(&place), 0);
    let mut before = arc.classified(&place).cycle;
    while (0.0..=1.0).contains(&place[place.len() - 1]) {
        let step = arc.step(&place, &tangent, stride).and_then(|next| {
            let turned = arc.tangent(&next, &tangent)?;
            let is_near = (&next - &place - &tangent * stride).norm() < 0.6 * stride;
            (is_near && turned.dot(&tangent) > 0.5 && !arc.has_jumped(&next, &turned))
                .then_some((turned, next))
        });
        let Some((next_tangent, next)) = step else {
            stride /= 2.0;
            if stride < longest(&place) / 4096.0 {
                return branch;
            }
            continue;
        };
        let there = arc.classified(&next).cycle;
        let whole = BranchSegment { arc, place: &place, tangent: &tangent, length: stride };
        let turns = whole.changes(&before, (&next_tangent, &there));
        let mut parts = vec![(0.0, place.clone(), None)];
        parts.extend(turns.into_iter().filter_map(|(at, turn)| Some((at, whole.at(at)?, Some(turn)))));
        parts.push((stride, next.clone(), None));
        for pair in parts.windows(2) {
            let [(low, first, _), (high, last, turn)] = pair else { unreachable!("windows of two") };
            let ends = [first, last].map(|place| place[place.len() - 1] * steps as f64);
            for k in integers_between(ends, steps) {
                let value = k as f64 / steps as f64;
                let Some(there) = whole.position_at(value, [(*low, first), (*high, last)]) else { continue };
                if add(&mut branch, &there, BranchPointKind::Asked(k)) {
                    return branch;
                }
            }
            let is_within = (0.0..=1.0).contains(&last[last.len() - 1]);
            branch.turns.extend(turn.filter(|_| is_within));
            let mark = turn.map_or(BranchPointKind::Between, |turn| BranchPointKind::Change(turn.change));
            if is_within && add(&mut branch, last, mark) || turn.is_some_and(|turn| turn.change.is_end()) {
                return branch;
            }
        }
        (place, tangent, before) = (next, next_tangent, there);
        stride = (1.5 * stride).min(longest(&place));
        // A curve may wind forever within the range, so the number of steps is limited.
        strides += 1;
        if strides > 20 * steps {
            return branch;
        }
    }
    branch.is_cut = false;
    branch
}

/// Returns the integers from 0 to `most` between two numbers, without the first number.
fn integers_between([from, to]: [f64; 2], most: usize) -> Vec<usize> {
    let is_passed = |k: &usize| {
        let k = *k as f64;
        (from < k && k <= to) || (to <= k && k < from)
    };
    let passed = (0..=most).filter(is_passed);
    if from < to { passed.collect() } else { passed.rev().collect() }
}

/// Returns the scale of lengths on a branch: the size of the first cycle. If that is 0, estimates
/// how far the points of the cycle move while the parameter crosses its range.
fn first_size<M: Parametric>(map: &M, cycle: &PeriodicPoint, length: f64) -> f64 {
    if cycle.size > 0.0 {
        return cycle.size;
    }
    let rates = cycle.points.iter().map(|x| unit::size(&map.by_parameter(x)));
    let moved = rates.fold(0.0, f64::max) * length.abs();
    if moved.is_finite() { moved } else { 0.0 }
}

pub(super) trait Curve {
    fn parameter(&self, place: &BranchPosition) -> f64;

    fn classified(&self, place: &BranchPosition) -> BranchPoint;

    /// Returns the unit tangent nearest to the direction `near`.
    fn tangent(&self, place: &BranchPosition, near: &BranchPosition) -> Option<BranchPosition>;

    /// Finds the point of the curve in the hyperplane through `near` orthogonal to `across`, by
    /// Newton's method.
    fn corrected(&self, near: BranchPosition, across: &BranchPosition) -> Option<BranchPosition>;

    /// Takes a predictor step along the tangent, then corrects it.
    fn step(&self, place: &BranchPosition, tangent: &BranchPosition, stride: f64) -> Option<BranchPosition> {
        self.corrected(place + tangent * stride, tangent)
    }

    /// Returns the kind of bifurcation at which the parameter reverses its direction.
    fn turning_back(&self, _: &BranchPosition) -> BranchChange {
        BranchChange::Fold
    }

    /// Returns whether a step jumped to a steady state, or to a cycle of half the period.
    fn has_jumped(&self, _: &BranchPosition, _: &BranchPosition) -> bool {
        false
    }
}

/// The solution curve of cycles of a map in ε or a parameter.
struct CycleCurve<F> {
    map: F,
    unit: LengthUnit,
    from: f64,
    length: f64,
}

impl<M: Parametric, F: Fn(f64) -> M> CycleCurve<F> {
    fn map(&self, place: &BranchPosition) -> ScaledMap<M> {
        ScaledMap { map: (self.map)(self.parameter(place)), unit: self.unit }
    }

    fn cycle(place: &BranchPosition) -> DVector<f64> {
        place.rows(0, place.len() - 1).into_owned()
    }

    /// Returns the derivatives of all φ(xᵢ) − xᵢ₊₁. The last column belongs to the parameter, and
    /// the others to the points xᵢ.
    fn slope(&self, place: &BranchPosition) -> Option<DMatrix<f64>> {
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
}

impl<M: Parametric, F: Fn(f64) -> M> Curve for CycleCurve<F> {
    fn parameter(&self, place: &BranchPosition) -> f64 {
        self.from + self.length * place[place.len() - 1]
    }

    fn classified(&self, place: &BranchPosition) -> BranchPoint {
        let (map, cycle) = (self.map(place), Self::cycle(place));
        let residual = defect(&map, cycle.as_slice()).map_or(f64::NAN, |gaps| gaps.amax());
        let cycle = PeriodicPoint::classified(&map, cycle.as_slice(), residual);
        let eps = map.map.eps().approximate();
        BranchPoint { parameter: self.parameter(place), eps, cycle, mark: BranchPointKind::Between }
    }

    fn tangent(&self, place: &BranchPosition, near: &BranchPosition) -> Option<BranchPosition> {
        let wide = self.slope(place)?;
        // The tangent is `near`, projected onto the null space of the derivative `wide`.
        let out = least_norm_solution(wide.clone(), &(&wide * near))?;
        (near - out).try_normalize(1e-8)
    }

    fn corrected(&self, mut next: BranchPosition, across: &BranchPosition) -> Option<BranchPosition> {
        const NEWTON_ITERATIONS: usize = 12;
        const RESIDUAL_TOLERANCE: f64 = 1e-12;

        let gaps_at = |there: &BranchPosition| defect(&self.map(there), Self::cycle(there).as_slice());
        for _ in 0..NEWTON_ITERATIONS {
            let gaps = gaps_at(&next)?;
            let wide = self.slope(&next)?;
            let rows = wide.nrows();
            let mut square = wide.insert_row(rows, 0.0);
            square.set_row(rows, &across.transpose());
            let nearer = &next - least_norm_solution(square, &gaps.push(0.0))?;
            if gaps.amax() <= RESIDUAL_TOLERANCE * next.amax().max(1.0) {
                // Near a double multiplier 1, the cycle's error is about the square root of the
                // residual `gaps`. One more Newton step is kept if it has a smaller residual.
                let is_nearer = gaps.amax() > NEGLIGIBLE_RESIDUAL
                    && gaps_at(&nearer).is_some_and(|left| left.amax() < gaps.amax());
                return Some(if is_nearer { nearer } else { next });
            }
            next = nearer;
        }
        None
    }
}
