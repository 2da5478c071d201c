//! Cycles of the flow: as many steps close up as are asked for, and ε is found with the points.
//!
//! In: the map at each ε, and a point and an ε near a cycle of the flow. Out: N points that the map
//! closes, their ε, and the period 2εN. At fixed ε a map of a flow has hardly any cycles: near a
//! hyperbolic cycle of the flow it has an invariant curve, on which it turns by an angle that
//! depends on ε. The points close up at the ε whose angle is a full turn in N steps.

use kahan_core::nalgebra::{DMatrix, DVector};

use super::Parametric;
use super::cycle::{CLOSED, NoPeriodicPoint, PeriodicPoint};
use super::newton::{NOTHING, defect, least_norm};
use super::unit::{self, InUnits, Unit};

/// A cycle of the flow, followed by N steps of the map.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FlowCycle {
    /// The points, and their multipliers, one of which is that of the direction of the flow, 1.
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

/// Finds a cycle of the flow near the orbit of `start` at `eps`, which comes back after about `steps`
/// steps. `map` makes the map at each ε, with its derivative by ε.
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
/// Cost: some rounds of Newton's method, each of N derivatives of the map and one decomposition of a
/// matrix with a row for each variable.
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

/// Newton's method for the points, in units of their size, and ε.
struct Search<'a, F> {
    map: &'a F,
    unit: Unit,
    points: DVector<f64>,
    eps: f64,
}

/// A Newton step, and how far its equations are from having several solutions: the ratio of the
/// smallest singular value to the largest.
struct Correction {
    points: DVector<f64>,
    eps: f64,
    rank: f64,
}

impl<M: Parametric, F: Fn(f64) -> M> Search<'_, F> {
    fn from(map: &F, points: Vec<f64>, eps: f64) -> Result<Search<'_, F>, NoPeriodicPoint> {
        if !points.iter().all(|x| x.is_finite()) {
            return Err(NoPeriodicPoint::NotFinite);
        }
        let unit = Unit::of(unit::size(&points));
        let points = DVector::from_iterator(points.len(), points.iter().map(|x| x / unit.length));
        Ok(Search { map, unit, points, eps })
    }

    fn map_at(&self, eps: f64) -> InUnits<M> {
        InUnits { map: (self.map)(eps), unit: self.unit }
    }

    fn run(mut self) -> Result<FlowCycle, NoPeriodicPoint> {
        /// Newton's method doubles digits: what does not converge in so many does not converge.
        const ROUNDS: usize = 60;
        /// A smaller ratio of singular values is a family of cycles.
        const FAMILY: f64 = 1e-7;

        let mut gaps = defect(&self.map_at(self.eps), &self.points).ok_or(NoPeriodicPoint::NotFinite)?;
        let mut rank = f64::INFINITY;
        for _ in 0..ROUNDS {
            if gaps.amax() <= NOTHING {
                break;
            }
            let Some(correction) = self.correction(&gaps) else { break };
            rank = correction.rank;
            // Half the step, and half of that, until it is nearer.
            let nearer = (0..30).find_map(|halvings| {
                let part = 0.5f64.powi(halvings);
                let (points, eps) = (&self.points + &correction.points * part, self.eps + correction.eps * part);
                let is_ahead = eps * self.eps > 0.0;
                let gaps_there = is_ahead.then(|| defect(&self.map_at(eps), &points)).flatten()?;
                (gaps_there.amax() < gaps.amax()).then_some((points, eps, gaps_there))
            });
            let Some((points, eps, gaps_there)) = nearer else { break };
            (self.points, self.eps, gaps) = (points, eps, gaps_there);
        }
        let residual = gaps.amax();
        if residual > CLOSED * self.points.amax().max(self.unit.size) {
            return Err(NoPeriodicPoint::NotFound { residual: residual * self.unit.length });
        }
        if rank < FAMILY {
            return Err(NoPeriodicPoint::Family);
        }
        let cycle = PeriodicPoint::judged(&self.map_at(self.eps), &self.points, residual);
        Ok(FlowCycle { cycle, eps: self.eps })
    }

    /// Solves dxᵢ₊₁ = Aᵢ dxᵢ + bᵢ dε + gᵢ around the cycle, Aᵢ and bᵢ the derivatives of the map and gᵢ
    /// the gaps: all dxᵢ are affine functions of dx₀ and dε, of which the shortest solution is
    /// taken, as the points may slide along the cycle.
    fn correction(&self, gaps: &DVector<f64>) -> Option<Correction> {
        let map = self.map_at(self.eps);
        let n = map.dimension();
        // dxᵢ = rows · (dx₀, dε/ε, 1)
        let mut rows = DMatrix::zeros(n, n + 2);
        rows.view_mut((0, 0), (n, n)).fill_with_identity();
        let mut affine = Vec::with_capacity(self.points.len() / n + 1);
        for (x, gap) in self.points.as_slice().chunks(n).zip(gaps.as_slice().chunks(n)) {
            let mut next = map.derivative(x) * &rows;
            for (k, (rate, gap)) in map.by_parameter(x).into_iter().zip(gap).enumerate() {
                next[(k, n)] += rate * self.eps;
                next[(k, n + 1)] += gap;
            }
            affine.push(std::mem::replace(&mut rows, next));
        }
        // After the last step dx₀ comes again.
        for k in 0..n {
            rows[(k, k)] -= 1.0;
        }
        let matrix = rows.columns(0, n + 1).into_owned();
        let right = -rows.column(n + 1).into_owned();
        let singular = matrix.singular_values();
        let first = least_norm(matrix, &right)?.push(1.0);
        let points = affine.iter().flat_map(|rows| (rows * &first).as_slice().to_vec());
        let points = DVector::from_iterator(self.points.len(), points);
        let rank = singular.min() / singular.max();
        points.iter().all(|x| x.is_finite()).then(|| Correction { points, eps: first[n] * self.eps, rank })
    }
}
