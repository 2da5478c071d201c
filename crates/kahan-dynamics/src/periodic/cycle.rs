//! Periodic points of a map: Newton's method from a nearby start, multipliers and stability.

use std::fmt;

use kahan_core::nalgebra::{Complex, DMatrix, DVector, Schur};

use super::Differentiable;
use super::newton::newton_cycle;
use super::unit::{self, LengthUnit, ScaledMap};

/// A cycle x, φ(x), … of a map φ, with its multipliers.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PeriodicPoint {
    /// The points of the cycle, as many as the smallest period.
    pub points: Vec<Vec<f64>>,
    /// The largest component of |φ(xᵢ) − xᵢ₊₁| over the points xᵢ, where φ is the map.
    pub residual: f64,
    /// The eigenvalues of ∂φᵖ/∂x by decreasing modulus, for the map φ and the smallest period p.
    pub multipliers: Vec<Complex<f64>>,
    /// The dimension of the family of cycles around this cycle, or 0 for an isolated cycle. The
    /// dimension is that of the null space of ∂φᵖ/∂x − 1 for the map φ and the period p.
    pub family: usize,
    /// The scale for comparing lengths: the largest coordinate of the points or of the start.
    pub(super) size: f64,
    /// For each multiplier, the distance from the unit circle up to which it counts as on it.
    margins: Vec<f64>,
}

/// The linear stability of a cycle, from its multipliers μ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Stability {
    /// All multipliers have |μ| < 1.
    Attracting,
    /// Some multiplier has |μ| > 1, and none has |μ| < 1.
    Repelling,
    /// Some multiplier has |μ| > 1, and another has |μ| < 1.
    Saddle,
    /// No multiplier has |μ| > 1, and at least one has |μ| = 1.
    Neutral,
}

impl fmt::Display for Stability {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Attracting => "attracting",
            Self::Repelling => "repelling",
            Self::Saddle => "saddle",
            Self::Neutral => "neutral",
        })
    }
}

/// The reason why no cycle was found.
#[derive(Clone, Debug, PartialEq)]
pub enum NoPeriodicPoint {
    /// The period is 0, or the start has a wrong number of coordinates.
    Unfit,
    /// The orbit of the start meets a pole, or leaves the range of doubles.
    NotFinite,
    /// Newton's method did not converge.
    NotFound {
        /// The largest component of |φ(xᵢ) − xᵢ₊₁| that remained, for the map φ and the points xᵢ.
        residual: f64,
    },
    /// Cycles form a family with different periods, so one number of steps fits many values of ε.
    Family,
    /// The search for a cycle of the flow ended at a steady state.
    Still,
    /// Near the cycle found, there is no cycle with twice as many steps, so its steps are too
    /// coarse.
    Coarse,
    /// No close return of the orbit led to a cycle of about the requested period.
    NoReturn,
}

impl fmt::Display for NoPeriodicPoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unfit => f.write_str("a period is 1 or more, and a point has a number for each variable"),
            Self::NotFinite => {
                f.write_str("the orbit from there meets a pole or numbers beyond the range of doubles")
            }
            Self::NotFound { residual } => {
                write!(
                    f,
                    "Newton's method comes no nearer to a cycle than {residual:.1e}; begin nearer to one"
                )
            }
            Self::Family => f.write_str(
                "cycles of the flow form a family here, as those of conservative fields do, each with a period of its \
                 own; ask for a period T instead: K steps at the fixed eps = T/(2K)",
            ),
            Self::Still => f.write_str("the search ends at a steady state; begin nearer to a cycle"),
            Self::Coarse => f.write_str(
                "the map has a cycle there, and none of about the same period with twice as many steps; take a \
                 smaller eps (dt)",
            ),
            Self::NoReturn => f.write_str(
                "the orbit does not come back close to itself after about the time that was asked for; begin elsewhere, \
                 after a longer transient, or ask for another period",
            ),
        }
    }
}

impl std::error::Error for NoPeriodicPoint {}

/// The largest accepted residual, relative to the size of the cycle or of the start.
pub(super) const RESIDUAL_TOLERANCE: f64 = 1e-11;
/// The least tolerance in the test whether |μ| = 1 for a multiplier μ. A double multiplier is
/// accurate to only half of its digits.
const UNIT_CIRCLE_TOLERANCE: f64 = 1e-6;

impl PeriodicPoint {
    /// Classifies the cycle by its multipliers.
    #[must_use]
    pub fn stability(&self) -> Stability {
        let is_larger = self.outside() > 0;
        let with_margins = self.multipliers.iter().zip(&self.margins);
        let inside = with_margins.filter(|(one, margin)| size(one) < 1.0 - **margin).count();
        match (is_larger, inside > 0) {
            (true, true) => Stability::Saddle,
            (true, false) => Stability::Repelling,
            (false, _) if inside == self.multipliers.len() => Stability::Attracting,
            (false, _) => Stability::Neutral,
        }
    }

    /// Returns whether some multiplier counts as on the unit circle because of its error bound,
    /// although its printed modulus differs from 1.
    #[must_use]
    pub fn is_blurred(&self) -> bool {
        /// The least distance from 1 that shows in the printed digits.
        const LEAST_SHOWN_DISTANCE: f64 = 1e-5;

        let off = |(one, margin): (&Complex<f64>, &f64)| {
            let distance = (size(one) - 1.0).abs();
            distance > LEAST_SHOWN_DISTANCE && distance <= *margin
        };
        self.multipliers.iter().zip(&self.margins).any(off)
    }

    /// Returns the number of multipliers outside the unit circle, which come first in the list.
    pub(super) fn outside(&self) -> usize {
        let with_margins = self.multipliers.iter().zip(&self.margins);
        with_margins.take_while(|(one, margin)| size(one) > 1.0 + **margin).count()
    }

    pub(super) fn margin(&self, index: usize) -> f64 {
        self.margins[index]
    }

    /// Returns the scale for comparing lengths: about the largest coordinate of the points and the
    /// start.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// Reduces a cycle to its smallest period, and classifies it.
    pub(super) fn classified<M: Differentiable>(map: &ScaledMap<M>, cycle: &[f64], residual: f64) -> Self {
        let all: Vec<Vec<f64>> = cycle.chunks(map.dimension()).map(<[f64]>::to_vec).collect();
        let period = smallest_period(&all, unit::size(cycle).max(map.unit.size));
        Self::of_period(map, cycle, period, residual)
    }

    pub(super) fn of_period<M: Differentiable>(
        map: &ScaledMap<M>,
        cycle: &[f64],
        period: usize,
        residual: f64,
    ) -> Self {
        let largest = unit::size(cycle).max(map.unit.size);
        let all = || cycle.chunks(map.dimension()).take(period);
        let factors: Vec<DMatrix<f64>> = all().map(|x| map.derivative(x)).collect();
        let points = all().map(|x| map.outside(x)).collect();
        let Linearized { multipliers, family, margins } = Linearized::of(&factors);
        let (residual, size) = (residual * map.unit.length, largest * map.unit.length);
        PeriodicPoint { points, residual, multipliers, family, size, margins }
    }

    /// Removes the multiplier nearest to 1, because a flow's cycle always has the multiplier 1 in
    /// the direction of the flow.
    pub(super) fn of_flow(mut self) -> Self {
        let distance = |one: &Complex<f64>| size(&(one - Complex::new(1.0, 0.0)));
        let distances = self.multipliers.iter().map(distance).enumerate();
        if let Some((place, _)) = distances.min_by(|a, b| a.1.total_cmp(&b.1)) {
            self.multipliers.remove(place);
            self.margins.remove(place);
        }
        self.family = self.family.saturating_sub(1);
        self
    }
}

/// Multipliers, family dimension and error margins of a cycle. The type is not generic, so the
/// decompositions are compiled only once.
struct Linearized {
    multipliers: Vec<Complex<f64>>,
    family: usize,
    margins: Vec<f64>,
}

impl Linearized {
    /// Computes multipliers and margins from the derivatives along the orbit.
    fn of(factors: &[DMatrix<f64>]) -> Self {
        let (derivative, error) = product(factors);
        if !derivative.iter().all(|entry| entry.is_finite()) {
            // The decompositions below would not terminate for NaN or infinity, and are skipped.
            let n = derivative.nrows();
            let multipliers = vec![Complex::new(f64::NAN, f64::NAN); n];
            return Linearized { multipliers, family: 0, margins: vec![f64::INFINITY; n] };
        }
        let conditions = conditions(&derivative);
        let mut multipliers: Vec<Complex<f64>> = derivative.complex_eigenvalues().iter().copied().collect();
        multipliers.sort_by(|a, b| {
            size(b).total_cmp(&size(a)).then(b.re.total_cmp(&a.re)).then(b.im.total_cmp(&a.im))
        });
        let n = derivative.nrows();
        let left = (derivative - DMatrix::identity(n, n)).singular_values();
        let scale = left.max().max(1.0);
        let family = left.iter().filter(|value| **value < UNIT_CIRCLE_TOLERANCE * scale).count();
        let margin = |multiplier: &Complex<f64>| {
            let distance = |(own, _): &&(Complex<f64>, f64)| size(&(own - multiplier));
            let nearest = conditions.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            let condition = nearest.map_or(f64::INFINITY, |(_, condition)| *condition);
            UNIT_CIRCLE_TOLERANCE.max(condition * error)
        };
        let margins = multipliers.iter().map(margin).collect();
        Linearized { multipliers, family, margins }
    }
}

/// Returns P = Jₚ…J₁ for the factors Jₖ, and a first-order bound on the norm of the error of P.
///
/// For n×n matrices, the product Jₖ·(Jₖ₋₁…J₁) has an error of at most (n + 16) u ‖Jₖ‖ ‖Jₖ₋₁…J₁‖
/// with the unit roundoff u. The remaining factors multiply this error by at most ‖Jₚ…Jₖ₊₁‖. The
/// backward error of the eigenvalues adds 10 n u ‖P‖.
fn product(factors: &[DMatrix<f64>]) -> (DMatrix<f64>, f64) {
    const UNIT: f64 = f64::EPSILON / 2.0;

    let n = factors[0].nrows();
    let mut behind = vec![0.0; factors.len()];
    let mut tail = DMatrix::identity(n, n);
    for (norm, factor) in behind.iter_mut().zip(factors).rev() {
        *norm = tail.norm();
        tail *= factor;
    }
    let (mut product, mut error) = (DMatrix::identity(n, n), 0.0);
    for (factor, behind) in factors.iter().zip(behind) {
        error += (n + 16) as f64 * UNIT * factor.norm() * product.norm() * behind;
        product = factor * product;
    }
    error += 10.0 * n as f64 * UNIT * product.norm();
    (product, error)
}

/// Returns the eigenvalues of a matrix, each with its condition number ‖x‖‖y‖/|yᴴx| for the right
/// and left eigenvectors x and y. The condition number may be infinite or NaN.
fn conditions(matrix: &DMatrix<f64>) -> Vec<(Complex<f64>, f64)> {
    const MOST_ROUNDS: usize = 10_000;

    let n = matrix.nrows();
    let complex = matrix.map(|entry| Complex::new(entry, 0.0));
    let Some(schur) = Schur::try_new(complex, f64::EPSILON, MOST_ROUNDS) else { return Vec::new() };
    let (_, triangular) = schur.unpack();
    let least = f64::EPSILON * triangular.norm();
    // Divisors are differences of eigenvalues. `least` replaces those of smaller modulus.
    let pivot = |pivot: Complex<f64>| if size(&pivot) < least { Complex::new(least, 0.0) } else { pivot };
    let condition = |i: usize| {
        let eigenvalue = triangular[(i, i)];
        let mut right = vec![Complex::new(0.0, 0.0); n];
        let mut left = right.clone();
        (right[i], left[i]) = (Complex::new(1.0, 0.0), Complex::new(1.0, 0.0));
        for j in (0..i).rev() {
            let sum: Complex<f64> = (j + 1..=i).map(|k| triangular[(j, k)] * right[k]).sum();
            right[j] = -sum / pivot(triangular[(j, j)] - eigenvalue);
        }
        for j in i + 1..n {
            let sum: Complex<f64> = (i..j).map(|k| left[k] * triangular[(k, j)]).sum();
            left[j] = -sum / pivot(triangular[(j, j)] - eigenvalue);
        }
        // The scalar product of `left` and `right` is 1: only entry i is nonzero in both, and is 1.
        let norm = |vector: &[Complex<f64>]| vector.iter().map(size).fold(0.0, libm::hypot);
        (eigenvalue, norm(&right) * norm(&left))
    };
    (0..n).map(condition).collect()
}

pub(super) fn size(multiplier: &Complex<f64>) -> f64 {
    libm::hypot(multiplier.re, multiplier.im)
}

/// Finds a periodic point of a map near `start`. The smallest period of the point divides `period`.
///
/// Tolerances are relative to the size of `start` or of the cycle, whichever is larger. For a start
/// at 0, the size of the next point of the orbit is used.
///
/// Each step of Newton's method decomposes a matrix of dimension `period` times the number of
/// variables.
///
/// # Errors
/// Returns [`NoPeriodicPoint`] for invalid input, an orbit that is not finite, or no convergence.
pub fn periodic_point<M: Differentiable>(
    map: &M,
    start: &[f64],
    period: usize,
) -> Result<PeriodicPoint, NoPeriodicPoint> {
    if period == 0 || start.len() != map.dimension() {
        return Err(NoPeriodicPoint::Unfit);
    }
    let mut cycle = start.to_vec();
    for step in 1..period {
        let image = map.image(&cycle[(step - 1) * start.len()..]);
        cycle.extend(image);
    }
    if !cycle.iter().all(|x| x.is_finite()) {
        return Err(NoPeriodicPoint::NotFinite);
    }
    // The unit of length is the size of the first nonzero point of the orbit.
    let last = map.image(&cycle[(period - 1) * start.len()..]);
    let mut sizes = cycle.chunks(start.len()).chain([&last[..]]).map(unit::size);
    let map = ScaledMap { map, unit: LengthUnit::of(sizes.find(|size| *size > 0.0).unwrap_or(0.0)) };
    let cycle = DVector::from_iterator(cycle.len(), cycle.iter().map(|x| x / map.unit.length));
    let (cycle, residual) = newton_cycle(&map, cycle).ok_or(NoPeriodicPoint::NotFinite)?;
    if residual > RESIDUAL_TOLERANCE * cycle.amax().max(map.unit.size) {
        return Err(NoPeriodicPoint::NotFound { residual: residual * map.unit.length });
    }
    Ok(PeriodicPoint::classified(&map, cycle.as_slice(), residual))
}

fn smallest_period(points: &[Vec<f64>], size: f64) -> usize {
    /// The relative distance below which points are treated as equal.
    const EQUAL_POINTS_DISTANCE: f64 = 1e-7;

    let comes_again = |period: usize| {
        let pairs = points.iter().zip(&points[period..]);
        pairs.flat_map(|(a, b)| a.iter().zip(b)).all(|(a, b)| (a - b).abs() <= EQUAL_POINTS_DISTANCE * size)
    };
    let divides = |period: &usize| points.len().is_multiple_of(*period);
    (1..points.len()).filter(divides).find(|&period| comes_again(period)).unwrap_or(points.len())
}
