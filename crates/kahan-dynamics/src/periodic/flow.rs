//! Cycles of a flow as N-step cycles of the map, with ε as an unknown.
//!
//! Near a hyperbolic cycle of the flow, the map has an invariant curve, whose rotation number
//! depends on ε. Where the rotation number is 1/N, the map has a cycle of N points. The cycle of
//! the flow has the approximate period 2εN.

use kahan_core::nalgebra::{Complex, DVector};

use super::Parametric;
use super::condensed::{CondensedEquations, Solution, phase_direction};
use super::cycle::{NoPeriodicPoint, PeriodicPoint, RESIDUAL_TOLERANCE};
use super::newton::defect;
use super::returns::distance_from_parabola;
use super::unit::{self, LengthUnit, ScaledMap};

/// A cycle of a flow, represented by N steps of the map.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FlowCycle {
    /// The points, and the multipliers without the trivial one of the flow direction.
    pub cycle: PeriodicPoint,
    /// Half the time step at which N steps close the cycle.
    pub eps: f64,
}

impl FlowCycle {
    /// Returns the period 2εN, with an error of order ε².
    #[must_use]
    pub fn period(&self) -> f64 {
        2.0 * self.eps * self.cycle.points.len() as f64
    }

    /// Doubles the number of steps, which quarters the error of the period. For the period T of
    /// this cycle and T₂ of the result, T₂ + (T₂ − T)/3 has an error of order ε⁴.
    ///
    /// # Errors
    /// Returns [`NoPeriodicPoint::Coarse`] if no cycle of about this period is found, or an error
    /// of [`flow_cycle`].
    pub fn doubled<M: Parametric>(&self, map: impl Fn(f64) -> M) -> Result<Self, NoPeriodicPoint> {
        let eps = 0.5 * self.eps;
        let half = map(eps);
        let points = self.cycle.points.iter().flat_map(|x| [x.clone(), half.image(x)]);
        match Search::from(&map, points.flatten().collect(), eps)?.run() {
            Ok(found) if found.is_near(2 * self.cycle.points.len(), eps) => Ok(found),
            Ok(_) | Err(NoPeriodicPoint::NotFound { .. }) => Err(NoPeriodicPoint::Coarse),
            error => error,
        }
    }

    /// Returns whether the cycle has `steps` steps and nearly the given ε.
    #[must_use]
    pub fn is_near(&self, steps: usize, eps: f64) -> bool {
        /// Cycles whose ε differ by more than this fraction are regarded as different.
        const NEAR: f64 = 0.1;

        self.cycle.points.len() == steps && (self.eps / eps - 1.0).abs() < NEAR
    }

    /// If this cycle goes several times around a curve, returns a cycle that goes around once.
    fn single_round<M: Parametric>(self, map: &impl Fn(f64) -> M) -> Self {
        let steps = self.cycle.points.len();
        let dimension = self.cycle.points[0].len();
        let points: Vec<f64> = self.cycle.points.iter().flatten().copied().collect();
        let mut shorter = (2..=steps / 4).rev().filter(|rounds| goes_around(&points, dimension, *rounds));
        let found = shorter.find_map(|rounds| {
            let part = (steps + rounds / 2) / rounds;
            let eps = self.eps * steps as f64 / (rounds * part) as f64;
            let found = Search::of_orbit(map, &self.cycle.points[0], eps, part).ok()?.run().ok()?;
            found.is_near(part, eps).then_some(found)
        });
        found.unwrap_or(self)
    }
}

/// Returns whether the points go `rounds` times around a closed curve. For this, each point must
/// lie near a parabola through three successive points of the next round.
pub(super) fn goes_around(points: &[f64], dimension: usize, rounds: usize) -> bool {
    /// The largest distance from a parabola, relative to the largest second difference.
    const NEAR: f64 = 0.25;

    let steps = points.len() / dimension;
    let at = |i: usize| &points[i % steps * dimension..][..dimension];
    let three = |i: usize| [at(i + steps - 1), at(i), at(i + 1)];
    let bend = |[before, x, behind]: [&[f64]; 3]| {
        let entries = before.iter().zip(x).zip(behind);
        entries.map(|((before, x), behind)| (behind - 2.0 * x + before).powi(2)).sum::<f64>().sqrt()
    };
    let bends = (0..steps).map(|i| bend(three(i))).fold(0.0, f64::max);
    let part = steps / rounds;
    (0..steps).all(|i| {
        let apart = [part, part + 1].map(|part| distance_from_parabola(three(i + part), at(i)));
        apart[0].min(apart[1]) <= NEAR * bends
    })
}

/// Finds a cycle of the flow near the orbit of `start` at `eps` that returns after about `steps`
/// steps. `map` makes the map at an ε, with its derivative with respect to ε.
///
/// ```
/// use kahan_core::Dual;
/// use kahan_core::prelude::*;
/// use kahan_dynamics::periodic::flow_cycle;
///
/// kahan! {
///     pub struct Lorenz;
///     xdot = 10*(y - x);
///     ydot = 28*x - x*z - y;
///     zdot = x*y - 8/3*z;
/// }
///
/// let map = |eps| Lorenz.at(Dual::coordinate(eps, 0));
/// let found = flow_cycle(map, &[-13.76, -19.58, 27.0], 1.56 / 400.0, 200).unwrap();
/// let doubled = found.doubled(map).unwrap();
/// let period = doubled.period() + (doubled.period() - found.period()) / 3.0;
/// // Viswanath, "Symbolic dynamics and periodic orbits of the Lorenz attractor", 2003.
/// assert!((period - 1.558652210716).abs() < 1e-6);
/// ```
///
/// The cost is a few Newton steps with N Jacobians each, and small decompositions.
///
/// # Errors
/// Returns [`NoPeriodicPoint`] for an unfit start, an orbit that is not finite, no convergence, or
/// a family of cycles, as in conservative fields. The periods of a family vary, so N does not
/// determine ε.
pub fn flow_cycle<M: Parametric>(
    map: impl Fn(f64) -> M,
    start: &[f64],
    eps: f64,
    steps: usize,
) -> Result<FlowCycle, NoPeriodicPoint> {
    if steps < 2 || start.len() != map(eps).dimension() || eps.is_nan() || eps == 0.0 {
        return Err(NoPeriodicPoint::Unfit);
    }
    Ok(Search::of_orbit(&map, start, eps, steps)?.run()?.single_round(&map))
}

/// Newton's method. `place` holds all points divided by `unit`, then ε divided by `eps`.
struct Search<'a, F> {
    map: &'a F,
    unit: LengthUnit,
    eps: f64,
    place: DVector<f64>,
}

impl<M: Parametric, F: Fn(f64) -> M> Search<'_, F> {
    fn of_orbit<'a>(
        map: &'a F,
        start: &[f64],
        eps: f64,
        steps: usize,
    ) -> Result<Search<'a, F>, NoPeriodicPoint> {
        let (at, mut points) = (map(eps), start.to_vec());
        for step in 1..steps {
            points.extend(at.image(&points[(step - 1) * start.len()..]));
        }
        Search::from(map, points, eps)
    }

    fn from(map: &F, points: Vec<f64>, eps: f64) -> Result<Search<'_, F>, NoPeriodicPoint> {
        if !points.iter().all(|x| x.is_finite()) {
            return Err(NoPeriodicPoint::NotFinite);
        }
        let unit = LengthUnit::of(unit::size(&points));
        let place = points.iter().map(|x| x / unit.length).chain([1.0]).collect();
        Ok(Search { map, unit, eps, place: DVector::from_vec(place) })
    }

    fn points(place: &DVector<f64>) -> &[f64] {
        &place.as_slice()[..place.len() - 1]
    }

    fn map_at(&self, place: &DVector<f64>) -> ScaledMap<M> {
        ScaledMap { map: (self.map)(self.eps * place[place.len() - 1]), unit: self.unit }
    }

    fn gaps(&self, place: &DVector<f64>) -> Option<DVector<f64>> {
        // The number ε must keep its sign along the search.
        let is_ahead = place[place.len() - 1] > 0.0;
        is_ahead.then(|| defect(&self.map_at(place), Self::points(place)))?
    }

    fn run(mut self) -> Result<FlowCycle, NoPeriodicPoint> {
        const NEWTON_ITERATIONS: usize = 60;
        /// Once the residual relative to the cycle's size is below this, one last step is made.
        const NEAR: f64 = 1e-13;

        let mut gaps = self.gaps(&self.place).ok_or(NoPeriodicPoint::NotFinite)?;
        let mut rank = f64::INFINITY;
        for _ in 0..NEWTON_ITERATIONS {
            let is_near = gaps.amax() <= NEAR;
            let Some(correction) = self.correction(&gaps) else { break };
            rank = correction.rank;
            let nearer = (0..if is_near { 1 } else { 24 }).find_map(|halvings| {
                let place = &self.place + &correction.step * 0.5f64.powi(halvings);
                let gaps_there = self.gaps(&place)?;
                (gaps_there.amax() < gaps.amax()).then_some((place, gaps_there))
            });
            let Some((place, gaps_there)) = nearer else { break };
            (self.place, gaps) = (place, gaps_there);
            if is_near {
                break;
            }
        }
        self.classified(gaps.amax(), rank)
    }

    /// Returns the Newton step that has no component along the cycle.
    fn correction(&self, gaps: &DVector<f64>) -> Option<Solution> {
        let (map, points) = (self.map_at(&self.place), Self::points(&self.place));
        let rates = |x: &[f64], _| map.by_parameter(x).into_iter().map(|rate| rate * self.eps).collect();
        let equations = CondensedEquations::of(&map, points, Some(gaps), 1, rates);
        equations.solve(&[(&phase_direction(points, map.dimension(), 1), 0.0)])
    }

    fn classified(self, residual: f64, rank: f64) -> Result<FlowCycle, NoPeriodicPoint> {
        /// The cycle may belong to a family if the Newton equations are singular: their smallest
        /// singular value divided by the largest is below this.
        const FAMILY_RANK_RATIO: f64 = 1e-7;
        const NEARLY_FAMILY: f64 = 1e-4;
        const ONE: f64 = 1e-3;
        /// A curve shorter than about this, relative to the size of its points, is a steady state.
        const STEADY_STATE_SIZE: f64 = 1e-6;

        let map = self.map_at(&self.place);
        let points = Self::points(&self.place);
        let is_closed = residual <= RESIDUAL_TOLERANCE * unit::size(points).max(self.unit.size);
        let apart = points.iter().skip(map.dimension()).zip(points).map(|(next, x)| (next - x).abs());
        if is_closed && apart.fold(0.0, f64::max) * (points.len() as f64) < STEADY_STATE_SIZE {
            return Err(NoPeriodicPoint::Still);
        }
        let cycle = PeriodicPoint::classified(&map, points, residual).of_flow();
        let is_one = |one: &Complex<f64>| (one - Complex::new(1.0, 0.0)).norm_sqr() < ONE * ONE;
        let nearly = if is_closed { FAMILY_RANK_RATIO } else { NEARLY_FAMILY };
        if rank < nearly && cycle.multipliers.iter().any(is_one) {
            return Err(NoPeriodicPoint::Family);
        }
        if !is_closed {
            return Err(NoPeriodicPoint::NotFound { residual: residual * self.unit.length });
        }
        Ok(FlowCycle { cycle, eps: self.eps * self.place[self.place.len() - 1] })
    }
}

/// The limit for h → 0 of a number that depends on the step h.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Extrapolated {
    /// The limit.
    pub value: f64,
    /// The estimated error of the limit.
    pub error: f64,
}

impl Extrapolated {
    /// The powers of h in the error of a symmetric method of order 2, such as Kahan's.
    pub const EVEN: &'static [i32] = &[2, 4];
    /// The powers of h in the error of other methods of order 2, as for lifted fields.
    pub const ALL: &'static [i32] = &[2, 3, 4];

    /// Applies Richardson extrapolation to the values at N, 2N, 4N, … steps.
    ///
    /// # Panics
    /// If `values` does not have one entry more than `powers`.
    #[must_use]
    pub fn of(values: &[f64], powers: &[i32]) -> Self {
        assert_eq!(values.len(), powers.len() + 1, "each power is eliminated by one more value");
        let fine = values[values.len() - 1];
        let (mut column, mut before) = (values.to_vec(), fine);
        for power in powers {
            before = column[column.len() - 1];
            let factor = libm::exp2(f64::from(*power)) - 1.0;
            column = column.windows(2).map(|pair| pair[1] + (pair[1] - pair[0]) / factor).collect();
        }
        // If the observed order is not about 2, the value of the smallest h is not extrapolated.
        let [first, second] = [3, 2].map(|k| values[values.len() - k + 1] - values[values.len() - k]);
        let ratio = first / second;
        let is_regular = (2.0..8.0).contains(&ratio) || second == 0.0;
        let [value, error] =
            if is_regular { [column[0], 2.0 * (column[0] - before)] } else { [fine, second] };
        Extrapolated { value, error: error.abs().max(4.0 * f64::EPSILON * value.abs()) }
    }
}
