//! Cycles of the flow: as many steps close up as are asked for, and ε is found with the points.
//!
//! In: the map at each ε, and a point and an ε near a cycle of the flow. Out: N points that the map
//! closes, their ε, and the period 2εN. At fixed ε a map of a flow has hardly any cycles: near a
//! hyperbolic cycle of the flow it has an invariant curve, on which it turns by an angle that
//! depends on ε. The points close up at the ε whose angle is a full turn in N steps.

use kahan_core::nalgebra::{Complex, DVector};

use super::Parametric;
use super::condensed::{Condensed, Solution, along};
use super::cycle::{CLOSED, NoPeriodicPoint, PeriodicPoint};
use super::newton::defect;
use super::unit::{self, InUnits, Unit};

/// A cycle of the flow, followed by N steps of the map.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FlowCycle {
    /// The points, and their multipliers but for that of the direction of the flow, which is 1.
    pub cycle: PeriodicPoint,
    /// Half the time step at which N steps close up.
    pub eps: f64,
}

impl FlowCycle {
    /// Returns the period, 2εN; its error is of order ε².
    #[must_use]
    pub fn period(&self) -> f64 {
        2.0 * self.eps * self.cycle.points.len() as f64
    }

    /// Finds the same cycle with twice as many steps. A quarter of the error of the period is left:
    /// with the periods T and T₂ of both, T₂ + (T₂ − T)/3 has an error of order ε⁴.
    ///
    /// # Errors
    /// [`NoPeriodicPoint`], as [`flow_cycle`].
    pub fn doubled<M: Parametric>(&self, map: impl Fn(f64) -> M) -> Result<Self, NoPeriodicPoint> {
        let eps = 0.5 * self.eps;
        let half = map(eps);
        let points = self.cycle.points.iter().flat_map(|x| [x.clone(), half.image(x)]);
        Search::from(&map, points.flatten().collect(), eps)?.run()
    }
}

/// Finds a cycle of the flow near the orbit of `start` at `eps`, which comes back after about
/// `steps` steps. `map` makes the map at each ε, with its derivative by ε.
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
/// Cost: some rounds of Newton's method, each of N derivatives of the map and one decomposition of
/// a matrix with a row for each variable.
///
/// # Errors
/// [`NoPeriodicPoint`] where the start does not fit, the orbit is not finite, none is found, or the
/// cycles of the flow form a family, as those of conservative fields do: their periods vary along
/// the family, and ε does not follow from the number of steps.
pub fn flow_cycle<M: Parametric>(
    map: impl Fn(f64) -> M,
    start: &[f64],
    eps: f64,
    steps: usize,
) -> Result<FlowCycle, NoPeriodicPoint> {
    let first = map(eps);
    if steps < 2 || start.len() != first.dimension() || eps.is_nan() || eps == 0.0 {
        return Err(NoPeriodicPoint::Unfit);
    }
    let mut points = start.to_vec();
    for step in 1..steps {
        points.extend(first.image(&points[(step - 1) * start.len()..]));
    }
    Search::from(&map, points, eps)?.run()
}

/// Newton's method for the points, in units of their size, and behind them ε, in units of the
/// first.
struct Search<'a, F> {
    map: &'a F,
    unit: Unit,
    eps: f64,
    place: DVector<f64>,
}

impl<M: Parametric, F: Fn(f64) -> M> Search<'_, F> {
    fn from(map: &F, points: Vec<f64>, eps: f64) -> Result<Search<'_, F>, NoPeriodicPoint> {
        if !points.iter().all(|x| x.is_finite()) {
            return Err(NoPeriodicPoint::NotFinite);
        }
        let unit = Unit::of(unit::size(&points));
        let place = points.iter().map(|x| x / unit.length).chain([1.0]).collect();
        Ok(Search { map, unit, eps, place: DVector::from_vec(place) })
    }

    fn points(place: &DVector<f64>) -> &[f64] {
        &place.as_slice()[..place.len() - 1]
    }

    fn map_at(&self, place: &DVector<f64>) -> InUnits<M> {
        InUnits { map: (self.map)(self.eps * place[place.len() - 1]), unit: self.unit }
    }

    fn gaps(&self, place: &DVector<f64>) -> Option<DVector<f64>> {
        // A step backwards would be another search.
        let is_ahead = place[place.len() - 1] > 0.0;
        is_ahead.then(|| defect(&self.map_at(place), Self::points(place)))?
    }

    fn run(mut self) -> Result<FlowCycle, NoPeriodicPoint> {
        /// The most rounds of Newton's method, which doubles the digits in each.
        const ROUNDS: usize = 60;
        /// A defect, in units of the cycle's size, that one more step reduces to roundings.
        const NEAR: f64 = 1e-13;

        let mut gaps = self.gaps(&self.place).ok_or(NoPeriodicPoint::NotFinite)?;
        let mut rank = f64::INFINITY;
        for _ in 0..ROUNDS {
            let is_near = gaps.amax() <= NEAR;
            let Some(correction) = self.correction(&gaps) else { break };
            rank = correction.rank;
            // Half the step, and half of that, until it is nearer.
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
        self.judged(gaps.amax(), rank)
    }

    /// Newton's step, which does not slide along the cycle.
    fn correction(&self, gaps: &DVector<f64>) -> Option<Solution> {
        let (map, points) = (self.map_at(&self.place), Self::points(&self.place));
        let rates = |x: &[f64], _| map.by_parameter(x).into_iter().map(|rate| rate * self.eps).collect();
        let equations = Condensed::of(&map, points, Some(gaps), 1, rates);
        equations.solve(&[(&along(points, map.dimension(), 1), 0.0)])
    }

    /// The cycle that the search came to.
    fn judged(self, residual: f64, rank: f64) -> Result<FlowCycle, NoPeriodicPoint> {
        /// A smaller ratio of singular values, with a second multiplier this near to 1, is a family
        /// of cycles; where the map has none of its own, the ratio is a power of ε.
        const FAMILY: f64 = 1e-7;
        const NEARLY_FAMILY: f64 = 1e-4;
        const ONE: f64 = 1e-3;
        /// Points no further apart, in units of their size, stand still.
        const STILL: f64 = 1e-6;

        let map = self.map_at(&self.place);
        let points = Self::points(&self.place);
        let is_closed = residual <= CLOSED * unit::size(points).max(self.unit.size);
        if !is_closed {
            let residual = residual * self.unit.length;
            let is_family = rank < NEARLY_FAMILY;
            return Err(if is_family {
                NoPeriodicPoint::Family
            } else {
                NoPeriodicPoint::NotFound { residual }
            });
        }
        let apart = points.iter().skip(map.dimension()).zip(points).map(|(next, x)| (next - x).abs());
        if apart.fold(0.0, f64::max) * (points.len() as f64) < STILL {
            return Err(NoPeriodicPoint::Still);
        }
        let cycle = PeriodicPoint::judged(&map, points, residual).of_flow();
        let is_one = |one: &Complex<f64>| (one - Complex::new(1.0, 0.0)).norm_sqr() < ONE * ONE;
        if rank < FAMILY && cycle.multipliers.iter().any(is_one) {
            return Err(NoPeriodicPoint::Family);
        }
        Ok(FlowCycle { cycle, eps: self.eps * self.place[self.place.len() - 1] })
    }
}

/// A number that depends on the number of steps N, at infinitely many.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Extrapolated {
    /// The limit.
    pub value: f64,
    /// About how far it may be from the limit.
    pub error: f64,
}

impl Extrapolated {
    /// Extrapolates from the values at N, 2N and 4N steps, whose errors are a power series in ε².
    /// The error that is told also holds where they have odd powers from ε³ on.
    #[must_use]
    pub fn of([coarse, middle, fine]: [f64; 3]) -> Self {
        let [first, second] = [(coarse, middle), (middle, fine)].map(|(n, n2)| n2 + (n2 - n) / 3.0);
        let value = second + (second - first) / 15.0;
        // The extrapolation gains nothing where the error is not of order 2.
        let ratio = (middle - coarse) / (fine - middle);
        let is_regular = (2.0..8.0).contains(&ratio) || fine == middle;
        let error = if is_regular { 2.0 * (value - second).abs() } else { (value - fine).abs() };
        Extrapolated { value, error: error.max(4.0 * f64::EPSILON * value.abs()) }
    }
}
