//! The Taylor series of a trajectory of a quadratic field.
//!
//! # Recurrence
//!
//! The series x(t) = Σ xₖ sᵏ, s = t − t₀, solves ẋ = Q(x,x) + Bx + c if
//!
//! (k + 1) xₖ₊₁ = Σ_{i+j=k} Q(xᵢ,xⱼ) + Bxₖ + [k = 0] c.
//!
//! Each coefficient takes one Cauchy product of the earlier coefficients. The unit of time is a
//! power of 2 near the radius of convergence, so that coefficients stay in range.

use kahan_core::nalgebra::{SMatrix, SVector};

use kahan_core::{Dd, FloatScalar, QuadraticField};

use super::norm;

/// A scalar for flows, `f64` or [`Dd`], with the length of its Taylor series.
pub(crate) trait SeriesScalar: FloatScalar + From<f64> + From<Dd> + Into<Dd> {
    /// The number of terms after x₀. More terms give fewer steps, but the cost of a step grows with
    /// the square of this number.
    const TERMS: usize = if Self::SHORT_BITS > f64::SHORT_BITS { 30 } else { 18 };

    /// The fraction h/ρ for the step h and the radius of convergence ρ. The first omitted term is
    /// about (h/ρ)^(TERMS + 1): 0.14¹⁹ ≈ 6·10⁻¹⁷ and 0.09³¹ ≈ 4·10⁻³³.
    const PART_OF_RADIUS: f64 = if Self::SHORT_BITS > f64::SHORT_BITS { 0.09 } else { 0.14 };
}

impl<T: FloatScalar + From<f64> + From<Dd> + Into<Dd>> SeriesScalar for T {}

/// A field ẋ = Q(x,x) + Bx + c with the linear part B and the constant part c.
#[derive(Clone, Debug)]
pub(super) struct Expansion<'a, F, T, const N: usize> {
    field: &'a F,
    linear: SMatrix<T, N, N>,
    constant: SVector<T, N>,
}

#[derive(Clone, Debug)]
pub(super) struct Series<T, const N: usize> {
    /// The coefficients x₀, x₁, … of powers of rate·(t − t₀).
    pub(super) coefficients: Vec<SVector<T, N>>,
    pub(super) rate: f64,
    /// The estimated radius of convergence, infinite if the last coefficients are 0.
    pub(super) radius: f64,
    /// The rate ‖ẍ‖∞/‖ẋ‖∞ at which the velocity turns, or 0 at rest.
    pub(super) turning: f64,
}

impl<'a, T: SeriesScalar, F: QuadraticField<T, N>, const N: usize> Expansion<'a, F, T, N> {
    pub(super) fn of(field: &'a F) -> Self {
        let origin = SVector::repeat(T::zero());
        Self { field, linear: field.field_jacobian(&origin), constant: field.field(&origin) }
    }

    /// Expands the solution at `start`. The guess `rate` of 1/ρ, for the radius of convergence ρ,
    /// is corrected by a few trials. The cost is about TERMS²/4 evaluations of the bilinear form.
    pub(super) fn at(&self, start: SVector<T, N>, rate: f64) -> Series<T, N> {
        const NEAR: f64 = (1_u64 << 16) as f64;
        const TRIALS: usize = 16;
        let mut rate = power_of_two(rate);
        let mut series = self.in_units(start, rate);
        for _ in 0..TRIALS {
            let size = series.radius * rate;
            if (1.0 / NEAR..=NEAR).contains(&size) || norm(&series.coefficients[1]) == 0.0 {
                break;
            }
            // If coefficients underflow, the rate is too large. If they overflow, it is too small.
            rate = power_of_two(match size {
                size if size == f64::INFINITY => rate / NEAR,
                size if size > 0.0 => rate / size,
                _ => rate * NEAR,
            });
            let other = self.in_units(start, rate);
            if size == f64::INFINITY && other.radius == f64::INFINITY {
                // The remaining coefficients are 0, so the solution is a polynomial in t.
                break;
            }
            series = other;
        }
        series
    }

    fn in_units(&self, start: SVector<T, N>, rate: f64) -> Series<T, N> {
        let two = T::from(2.0);
        let unit = T::from(1.0 / rate);
        let mut series = Vec::with_capacity(T::TERMS + 1);
        series.push(start);
        for k in 0..T::TERMS {
            let mut sum = times(&self.linear, &series[k]);
            if k == 0 {
                sum += self.constant;
            }
            // Q is symmetric, so each pair (i, j) is computed once.
            for i in 0..k.div_ceil(2) {
                sum += self.field.bilinear(&series[i], &series[k - i]).map(|entry| two * entry);
            }
            if k % 2 == 0 {
                sum += self.field.bilinear(&series[k / 2], &series[k / 2]);
            }
            // To avoid an overflow of single terms, only the finished sum is multiplied by `unit`.
            let divisor = T::from((k + 1) as f64);
            series.push(sum.map(|entry| entry * unit / divisor));
        }
        let (speed, bend) = (norm(&series[1]), norm(&series[2]));
        let turning = if speed > 0.0 { 2.0 * bend / speed * rate } else { 0.0 };
        let radius = radius(&series) / rate;
        Series { coefficients: series, rate, radius, turning }
    }
}

impl<T: SeriesScalar, const N: usize> Series<T, N> {
    /// Returns the longest step for which the series is accurate.
    pub(super) fn reach(&self) -> f64 {
        T::PART_OF_RADIUS * self.radius
    }

    pub(super) fn value(&self, s: T) -> SVector<T, N> {
        let (s, zero) = (s * T::from(self.rate), SVector::repeat(T::zero()));
        self.coefficients.iter().rev().fold(zero, |sum, coefficient| sum.map(|entry| entry * s) + coefficient)
    }
}

/// Estimates the radius of convergence ρ from the last two coefficients (Jorba and Zou, Exp. Math.
/// 14 (2005) 99). Each component has its own estimate, because a small component may grow.
///
/// Let p = [`PART_OF_RADIUS`](SeriesScalar::PART_OF_RADIUS), and let x₀, …, x_K be the coefficients
/// of a component. The estimate is h/p for the largest h such that some k ≤ K/2 satisfies |x_K|h^K
/// ≤ p^K |xₖ|hᵏ. A step h then omits terms of at most about p^K times the largest |xₖ|hᵏ.
fn radius<T: SeriesScalar, const N: usize>(series: &[SVector<T, N>]) -> f64 {
    let size = |k: usize, i: usize| series[k][i].approximate().abs();
    let estimate = |i: usize, last: usize| {
        let (left_out, allowed) = (size(last, i), T::PART_OF_RADIUS.powi(last as i32));
        if !left_out.is_finite() {
            return 0.0;
        }
        let step = |k: usize| libm::pow(allowed * (size(k, i) / left_out), 1.0 / (last - k) as f64);
        let longest = (0..=last / 2).map(step).fold(0.0, f64::max);
        if left_out > 0.0 { longest / T::PART_OF_RADIUS } else { f64::INFINITY }
    };
    let last = series.len() - 1;
    (0..N).map(|i| estimate(i, last).min(estimate(i, last - 1))).fold(f64::INFINITY, f64::min)
}

/// Returns the power of 2 nearest to a rate, limited to the range from 2^−400 to 2^400. The result
/// is 1 if the rate is 0 or NaN.
fn power_of_two(rate: f64) -> f64 {
    let exponent = libm::log2(rate).round();
    if exponent.is_finite() { libm::exp2(exponent.clamp(-400.0, 400.0)) } else { 1.0 }
}

fn times<T: SeriesScalar, const N: usize>(matrix: &SMatrix<T, N, N>, x: &SVector<T, N>) -> SVector<T, N> {
    SVector::from_fn(|i, _| (0..N).fold(T::zero(), |sum, j| sum + matrix[(i, j)] * x[j]))
}
