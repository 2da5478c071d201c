//! Continuation of a cycle of a flow in a parameter, with a fixed number of steps.
//!
//! The period varies along the branch, so ε is an unknown besides the points.

use std::ops::ControlFlow;

use kahan_core::nalgebra::DVector;

use super::Parametric;
use super::branch::{Branch, BranchPoint, BranchPointKind, BranchPosition, Curve, follow};
use super::changes::BranchChange;
use super::condensed::{CondensedEquations, phase_direction};
use super::cycle::PeriodicPoint;
use super::flow::{FlowCycle, goes_around};
use super::newton::defect;
use super::unit::{self, LengthUnit, ScaledMap};

/// Follows a cycle of a flow from the parameter value `from` towards `to`, like
/// [`branch`](super::branch()). Each point of the branch has its own ε.
///
/// `map` takes a parameter value and an ε. The two results are the map with its derivative with
/// respect to ε, and with respect to the parameter.
///
/// ```
/// use std::ops::ControlFlow;
///
/// use kahan_core::Dual;
/// use kahan_core::prelude::*;
/// use kahan_dynamics::periodic::{flow_branch, flow_cycle};
///
/// kahan! {
///     pub struct Rossler { a, b, c }
///     xdot = -y - z;
///     ydot = x + a*y;
///     zdot = b + x*z - c*z;
/// }
///
/// let (a, b) = (Dual::from_value(0.2), Dual::from_value(0.2));
/// let map = |c, eps| {
///     let by_eps = Rossler { a, b, c: Dual::from_value(c) }.at(Dual::coordinate(eps, 0));
///     [by_eps, Rossler { a, b, c: Dual::coordinate(c, 0) }.at(Dual::from_value(eps))]
/// };
/// let first = |eps| { let [by_eps, _] = map(2.5, eps); by_eps };
/// let cycle = flow_cycle(first, &[-3.5, 1.0, 0.03], 0.03, 100).unwrap();
/// let branch = flow_branch(map, &cycle, [2.5, 3.0], 10, |_| ControlFlow::Continue(()));
/// // The period doubles.
/// assert!((branch.turns[0].parameter - 2.83).abs() < 0.01);
/// ```
///
/// Each step takes a few Newton steps, as in [`flow_cycle`](super::flow_cycle), and each
/// bifurcation a few hundred.
pub fn flow_branch<M: Parametric>(
    map: impl Fn(f64, f64) -> [M; 2],
    cycle: &FlowCycle,
    [from, to]: [f64; 2],
    steps: usize,
    see: impl FnMut(&BranchPoint) -> ControlFlow<()>,
) -> Branch {
    let size = cycle.cycle.size();
    let many = cycle.cycle.points.len() as f64;
    let [unit, scaled] = [size, size * many.sqrt()].map(LengthUnit::of);
    let arc = FlowCycleCurve { map, unit, scaled, eps: cycle.eps, from, length: to - from };
    let points = cycle.cycle.points.iter().flatten().map(|x| x / scaled.length);
    let place = DVector::from_vec(points.chain([1.0, 0.0]).collect());
    follow(&arc, place, steps, see)
}

/// The solution curve of cycles of a flow. A position holds the scaled points, then ε relative to
/// the first ε, then the parameter relative to the range.
struct FlowCycleCurve<F> {
    map: F,
    unit: LengthUnit,
    scaled: LengthUnit,
    eps: f64,
    from: f64,
    length: f64,
}

impl<M: Parametric, F: Fn(f64, f64) -> [M; 2]> FlowCycleCurve<F> {
    fn points(place: &BranchPosition) -> &[f64] {
        &place.as_slice()[..place.len() - 2]
    }

    fn dimension(&self, place: &BranchPosition) -> usize {
        self.maps(place)[0].dimension()
    }

    /// Returns whether the cycle goes twice around a cycle of half the period.
    fn runs_twice(&self, place: &BranchPosition) -> bool {
        goes_around(Self::points(place), self.dimension(place), 2)
    }

    /// Returns √Σ|xᵢ − x₀|² over the points xᵢ, which measures the extent of the cycle.
    fn extent(&self, place: &BranchPosition) -> f64 {
        let (points, n) = (Self::points(place), self.dimension(place));
        (0..points.len()).map(|k| (points[k] - points[k % n]).powi(2)).sum::<f64>().sqrt()
    }

    fn eps(&self, place: &BranchPosition) -> f64 {
        self.eps * place[place.len() - 2]
    }

    fn maps(&self, place: &BranchPosition) -> [ScaledMap<M>; 2] {
        (self.map)(self.parameter(place), self.eps(place)).map(|map| ScaledMap { map, unit: self.scaled })
    }

    fn gaps(&self, place: &BranchPosition) -> Option<DVector<f64>> {
        let [by_eps, _] = self.maps(place);
        (place[place.len() - 2] > 0.0).then(|| defect(&by_eps, Self::points(place)))?
    }

    /// Linearizes the equations at a position. Also returns the direction along the cycle.
    fn equations(
        &self,
        place: &BranchPosition,
        gaps: Option<&DVector<f64>>,
    ) -> (CondensedEquations, BranchPosition) {
        let (maps, points) = (self.maps(place), Self::points(place));
        let units = [self.eps, self.length];
        let rates = |x: &[f64], other: usize| {
            maps[other].by_parameter(x).into_iter().map(|rate| rate * units[other]).collect()
        };
        (
            CondensedEquations::of(&maps[0], points, gaps, 2, rates),
            phase_direction(points, maps[0].dimension(), 2),
        )
    }
}

impl<M: Parametric, F: Fn(f64, f64) -> [M; 2]> Curve for FlowCycleCurve<F> {
    fn parameter(&self, place: &BranchPosition) -> f64 {
        self.from + self.length * place[place.len() - 1]
    }

    fn classified(&self, place: &BranchPosition) -> BranchPoint {
        let [map, _] = self.maps(place);
        let ratio = self.scaled.length / self.unit.length;
        let points: Vec<f64> = Self::points(place).iter().map(|x| x * ratio).collect();
        let map = ScaledMap { map: map.map, unit: self.unit };
        let residual = defect(&map, &points).map_or(f64::NAN, |gaps| unit::size(gaps.as_slice()));
        let cycle =
            PeriodicPoint::of_period(&map, &points, points.len() / map.dimension(), residual).of_flow();
        BranchPoint {
            parameter: self.parameter(place),
            eps: self.eps(place),
            cycle,
            mark: BranchPointKind::Between,
        }
    }

    fn tangent(&self, place: &BranchPosition, near: &BranchPosition) -> Option<BranchPosition> {
        let (equations, along) = self.equations(place, None);
        equations.solve(&[(&along, 0.0), (near, 1.0)])?.step.try_normalize(1e-8)
    }

    fn turning_back(&self, place: &BranchPosition) -> BranchChange {
        /// The extent below which the cycle is nearly a steady state, and the equations almost
        /// singular.
        const NEARLY_STEADY_EXTENT: f64 = 0.02;

        match (self.extent(place) < NEARLY_STEADY_EXTENT, self.runs_twice(place)) {
            (true, _) => BranchChange::Hopf,
            (false, true) => BranchChange::Halved,
            (false, false) => BranchChange::Fold,
        }
    }

    fn has_jumped(&self, place: &BranchPosition, tangent: &BranchPosition) -> bool {
        /// The extent below which Newton's method has converged to a steady state.
        const STEADY_STATE_EXTENT: f64 = 1e-6;

        if self.extent(place) < STEADY_STATE_EXTENT {
            return true;
        }
        let (moves, n) = (Self::points(tangent), self.dimension(place));
        let half = moves.len() / n / 2 * n;
        let apart = (0..half).map(|k| (moves[k] - moves[k + half]).abs()).fold(0.0, f64::max);
        apart < 0.5 * unit::size(moves) && self.runs_twice(place)
    }

    fn corrected(&self, mut next: BranchPosition, across: &BranchPosition) -> Option<BranchPosition> {
        const NEWTON_ITERATIONS: usize = 12;
        const RESIDUAL_TOLERANCE: f64 = 1e-12;

        let mut gaps = self.gaps(&next)?;
        for _ in 0..NEWTON_ITERATIONS {
            // The step is perpendicular to the branch, and does not shift the points along the
            // cycle.
            let (equations, along) = self.equations(&next, Some(&gaps));
            let nearer = &next + equations.solve(&[(&along, 0.0), (across, 0.0)])?.step;
            let gaps_there = self.gaps(&nearer)?;
            let is_closed = gaps.amax() <= RESIDUAL_TOLERANCE;
            if is_closed && gaps_there.amax() >= gaps.amax() {
                return Some(next);
            }
            (next, gaps) = (nearer, gaps_there);
            if is_closed {
                return Some(next);
            }
        }
        None
    }
}
