//! The Taylor series of a trajectory of a quadratic field.
//!
//! From x(t) = Σ xₖ sᵏ, s = t − t₀, and ẋ = Q(x,x) + Bx + c follows the recurrence
//!
//! (k + 1) xₖ₊₁ = Σ_{i+j=k} Q(xᵢ,xⱼ) + Bxₖ + [k = 0] c:
//!
//! one Cauchy product a coefficient, and no derivative of f beyond f′. Nothing here knows of Kahan's map, so a reference made
//! this way shares no mistake with it.

use kahan_core::nalgebra::{SMatrix, SVector};
use kahan_core::{Dd, QuadraticField};

use super::dense::Piece;

/// The terms beyond x₀. Cost falls with the number of steps and grows with its square; the least lies near the number of
/// digits.
const TERMS: usize = 30;

/// A step as a part of the radius of convergence ρ: the first term left out is about (h/ρ)³¹ ≈ 2·10⁻³³ of the solution.
const PART_OF_RADIUS: f64 = 0.09;

/// A field with what its series need beyond it.
#[derive(Clone, Debug)]
pub(super) struct Expansion<'a, F, const N: usize> {
    field: &'a F,
    linear: SMatrix<Dd, N, N>,
    constant: SVector<Dd, N>,
}

/// The series at one point, and how far it serves.
#[derive(Clone, Debug)]
pub(super) struct Series<const N: usize> {
    /// x₀, x₁, …
    coefficients: Vec<SVector<Dd, N>>,
    /// The radius of convergence, estimated from the last coefficients; infinite where they are 0.
    pub(super) radius: f64,
}

impl<'a, F: QuadraticField<Dd, N>, const N: usize> Expansion<'a, F, N> {
    pub(super) fn of(field: &'a F) -> Self {
        let origin = SVector::repeat(Dd::from(0.0));
        Expansion { field, linear: field.field_jacobian(&origin), constant: field.field(&origin) }
    }

    /// The series at x₀. Cost: about 250 evaluations of the bilinear form.
    pub(super) fn at(&self, start: SVector<Dd, N>) -> Series<N> {
        let two = Dd::from(2.0);
        let mut series = Vec::with_capacity(TERMS + 1);
        series.push(start);
        for k in 0..TERMS {
            let mut sum = times(&self.linear, &series[k]);
            if k == 0 {
                sum += self.constant;
            }
            // Q is symmetric: each pair once.
            for i in 0..k.div_ceil(2) {
                sum += self.field.bilinear(&series[i], &series[k - i]).map(|entry| two * entry);
            }
            if k % 2 == 0 {
                sum += self.field.bilinear(&series[k / 2], &series[k / 2]);
            }
            let divisor = Dd::from((k + 1) as f64);
            series.push(sum.map(|entry| entry / divisor));
        }
        let radius = radius(&series);
        Series { coefficients: series, radius }
    }
}

impl<const N: usize> Series<N> {
    /// How far the series may be used.
    pub(super) fn reach(&self) -> f64 {
        PART_OF_RADIUS * self.radius
    }

    /// x(t₀ + s).
    pub(super) fn value(&self, s: Dd) -> SVector<Dd, N> {
        let zero = SVector::repeat(Dd::from(0.0));
        self.coefficients.iter().rev().fold(zero, |sum, coefficient| sum.map(|entry| entry * s) + coefficient)
    }

    /// The same as a piece of a trajectory that begins at `start`.
    pub(super) fn piece(&self, start: Dd) -> Piece {
        let coefficients = self.coefficients.iter().flat_map(|x| x.iter().copied()).collect();
        Piece { start, dimension: N, coefficients }
    }
}

/// ρ from |xₖ| ~ |x₀|ρ⁻ᵏ in the last two terms, as Jorba and Zou, Exp. Math. 14 (2005) 99, have it.
fn radius<const N: usize>(series: &[SVector<Dd, N>]) -> f64 {
    let norm = |x: &SVector<Dd, N>| x.iter().map(|entry| f64::from(entry.abs())).fold(0.0, f64::max);
    let first = norm(&series[0]).max(norm(&series[1]));
    let estimate = |k: usize| {
        let last = norm(&series[k]);
        if last > 0.0 { (first / last).powf(1.0 / k as f64) } else { f64::INFINITY }
    };
    estimate(series.len() - 1).min(estimate(series.len() - 2))
}

fn times<const N: usize>(matrix: &SMatrix<Dd, N, N>, x: &SVector<Dd, N>) -> SVector<Dd, N> {
    SVector::from_fn(|i, _| (0..N).fold(Dd::from(0.0), |sum, j| sum + matrix[(i, j)] * x[j]))
}
