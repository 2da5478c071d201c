//! One cycle: found from a point near it, and judged.

use std::fmt;

use kahan_core::nalgebra::{Complex, DMatrix, DVector, Schur};

use super::Differentiable;
use super::newton::closed;
use super::unit::{self, InUnits, Unit};

/// The points of a cycle, x, φ(x), …, and what the map does near it.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PeriodicPoint {
    /// As many points as the smallest period.
    pub points: Vec<Vec<f64>>,
    /// The largest |φ(xᵢ) − xᵢ₊₁| in any variable.
    pub residual: f64,
    /// The multipliers: eigenvalues of ∂φᵖ/∂x, p the smallest period, the largest first.
    pub multipliers: Vec<Complex<f64>>,
    /// The dimension of the family of cycles of this period that it belongs to, 0 where it stands
    /// alone: how many directions ∂φᵖ/∂x leaves as they are.
    pub family: usize,
    /// About the largest coordinate of its points, or of the point that it was found from where
    /// that is larger, as the cycle may be a point whose coordinates are all 0: what lengths are
    /// compared with.
    pub(super) size: f64,
    /// How far each multiplier may be from the circle by rounding, if it is one of size 1.
    margins: Vec<f64>,
}

/// How orbits near a cycle behave, as its multipliers say it to first order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Stability {
    /// All multipliers are smaller than 1 in size.
    Attracting,
    /// Some are larger than 1, and none is smaller.
    Repelling,
    /// Some are larger than 1, and some smaller.
    Saddle,
    /// None is larger than 1, and not all are smaller.
    Neutral,
}

/// One word.
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

/// Why there is no periodic point.
#[derive(Clone, Debug, PartialEq)]
pub enum NoPeriodicPoint {
    /// The period is 0, or the point has not a number a variable.
    Unfit,
    /// The orbit of the point meets a pole, or numbers beyond the range of doubles.
    NotFinite,
    /// Newton's method came no nearer than this.
    NotFound {
        /// The largest |φ(xᵢ) − xᵢ₊₁| that was left.
        residual: f64,
    },
    /// Cycles of the flow form a family here, so that ε does not follow from the number of steps.
    Family,
    /// The search for a cycle of the flow came to a point that stands still.
    Still,
    /// A cycle is found, and none near it of twice as many steps.
    Coarse,
    /// No orbit was found that comes back close to itself, and leads to a cycle of about the period
    /// that was asked for.
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

/// What is left where a cycle is closed, relative to its size, or that of the point it was found
/// from.
pub(super) const CLOSED: f64 = 1e-11;
/// How far a multiplier of size 1 may be from it where the derivative is not large, as a double
/// eigenvalue loses half the digits.
const CIRCLE: f64 = 1e-6;

impl PeriodicPoint {
    /// What the multipliers say.
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

    /// Whether a multiplier counts as one of size 1 whose digits say otherwise, as its error is
    /// large.
    #[must_use]
    pub fn is_blurred(&self) -> bool {
        /// A distance from 1 that printed digits do not show.
        const SHOWN: f64 = 1e-5;

        let off = |(one, margin): (&Complex<f64>, &f64)| {
            let distance = (size(one) - 1.0).abs();
            distance > SHOWN && distance <= *margin
        };
        self.multipliers.iter().zip(&self.margins).any(off)
    }

    /// How many multipliers are larger than 1 in size; they come first.
    pub(super) fn outside(&self) -> usize {
        let with_margins = self.multipliers.iter().zip(&self.margins);
        with_margins.take_while(|(one, margin)| size(one) > 1.0 + **margin).count()
    }

    /// How far the multiplier with this index may be from the circle by rounding, if its size is 1.
    pub(super) fn margin(&self, index: usize) -> f64 {
        self.margins[index]
    }

    /// What lengths near it are compared with: the largest coordinate of its points, or about that
    /// of the point it was found from, where that is larger.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// Returns the cycle of these points with the smallest period, in units in which the point that
    /// it was found from has a size of about 1.
    pub(super) fn judged<M: Differentiable>(map: &InUnits<M>, cycle: &[f64], residual: f64) -> Self {
        let all: Vec<Vec<f64>> = cycle.chunks(map.dimension()).map(<[f64]>::to_vec).collect();
        let period = smallest_period(&all, unit::size(cycle).max(map.unit.size));
        Self::of_period(map, cycle, period, residual)
    }

    /// Returns the cycle of the first `period` points, in the units of [`judged`](Self::judged).
    pub(super) fn of_period<M: Differentiable>(
        map: &InUnits<M>,
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

    /// A cycle of a flow without the multiplier of the flow's own direction, that nearest to 1.
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

/// What the derivative of the map along a cycle says. A function of its own, so that the
/// decompositions are compiled here, once, and not anew for each type of map.
struct Linearized {
    multipliers: Vec<Complex<f64>>,
    family: usize,
    margins: Vec<f64>,
}

impl Linearized {
    /// Of the derivatives at the points, in their order.
    fn of(factors: &[DMatrix<f64>]) -> Self {
        let (derivative, error) = product(factors);
        if !derivative.iter().all(|entry| entry.is_finite()) {
            // Decompositions of such a matrix do not end.
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
        let family = left.iter().filter(|value| **value < CIRCLE * scale).count();
        let margin = |multiplier: &Complex<f64>| {
            let distance = |(own, _): &&(Complex<f64>, f64)| size(&(own - multiplier));
            let nearest = conditions.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            let condition = nearest.map_or(f64::INFINITY, |(_, condition)| *condition);
            CIRCLE.max(condition * error)
        };
        let margins = multipliers.iter().map(margin).collect();
        Linearized { multipliers, family, margins }
    }
}

/// The product P of the derivatives Jₚ…J₁, and a bound on the norm of what is wrong with it, to
/// first order in the unit u of rounding.
///
/// Each Jₖ is known to some roundings, and its product with Jₖ₋₁…J₁ is rounded. That is an error of
/// (n + 16) u ‖Jₖ‖ ‖Jₖ₋₁…J₁‖, which the later factors multiply by ‖Jₚ…Jₖ₊₁‖ at most.
///
/// The eigenvalues of P are those of a matrix that is 10 n u ‖P‖ away from it.
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

/// The eigenvalues of a matrix, each with its condition ‖x‖‖y‖/|yᴴx| of right and left eigenvectors
/// x and y: how far it moves, to first order, where the matrix changes by one of norm 1. Infinite,
/// or not a number, where there are no such eigenvectors.
fn conditions(matrix: &DMatrix<f64>) -> Vec<(Complex<f64>, f64)> {
    const MOST_ROUNDS: usize = 10_000;

    let n = matrix.nrows();
    let complex = matrix.map(|entry| Complex::new(entry, 0.0));
    let Some(schur) = Schur::try_new(complex, f64::EPSILON, MOST_ROUNDS) else { return Vec::new() };
    let (_, triangular) = schur.unpack();
    let least = f64::EPSILON * triangular.norm();
    // A multiple eigenvalue counts as several that are a rounding apart.
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
        // Both are 1 at i, and elsewhere one of them is 0.
        let norm = |vector: &[Complex<f64>]| vector.iter().map(size).fold(0.0, f64::hypot);
        (eigenvalue, norm(&right) * norm(&left))
    };
    (0..n).map(condition).collect()
}

/// |μ|
pub(super) fn size(multiplier: &Complex<f64>) -> f64 {
    multiplier.re.hypot(multiplier.im)
}

/// The periodic point of a map near `start`, whose period divides `period`.
///
/// How near is near enough is relative to the size of `start`, or of the cycle where that is
/// larger, or of the next point of the orbit where `start` is 0: the answer does not depend on the
/// unit of length.
///
/// Cost: some rounds of Newton's method, each a decomposition of a matrix of `period` times the
/// number of variables.
///
/// # Errors
/// [`NoPeriodicPoint`] where the start does not fit, the orbit is not finite, or none is found.
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
    // A start at 0 may still move.
    let last = map.image(&cycle[(period - 1) * start.len()..]);
    let mut sizes = cycle.chunks(start.len()).chain([&last[..]]).map(unit::size);
    let map = InUnits { map, unit: Unit::of(sizes.find(|size| *size > 0.0).unwrap_or(0.0)) };
    let cycle = DVector::from_iterator(cycle.len(), cycle.iter().map(|x| x / map.unit.length));
    let (cycle, residual) = closed(&map, cycle).ok_or(NoPeriodicPoint::NotFinite)?;
    if residual > CLOSED * cycle.amax().max(map.unit.size) {
        return Err(NoPeriodicPoint::NotFound { residual: residual * map.unit.length });
    }
    Ok(PeriodicPoint::judged(&map, cycle.as_slice(), residual))
}

/// The smallest divisor of the number of points after which they come again.
fn smallest_period(points: &[Vec<f64>], size: f64) -> usize {
    /// Points that are nearer than this, relative to their size, are one.
    const SAME: f64 = 1e-7;

    let comes_again = |period: usize| {
        let pairs = points.iter().zip(&points[period..]);
        pairs.flat_map(|(a, b)| a.iter().zip(b)).all(|(a, b)| (a - b).abs() <= SAME * size)
    };
    let divides = |period: &usize| points.len().is_multiple_of(*period);
    (1..points.len()).filter(divides).find(|&period| comes_again(period)).unwrap_or(points.len())
}
