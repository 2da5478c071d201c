//! The Taylor series of a trajectory of a quadratic field.
//!
//! From x(t) = Σ xₖ sᵏ, s = t − t₀, and ẋ = Q(x,x) + Bx + c follows the recurrence
//!
//! (k + 1) xₖ₊₁ = Σ_{i+j=k} Q(xᵢ,xⱼ) + Bxₖ + [k = 0] c:
//!
//! one Cauchy product a coefficient, and no derivative of f beyond f′. Time is counted in units of
//! the radius of convergence, or nearly, a power of 2, so that coefficients neither overflow nor
//! vanish where the motion is very fast or slow.

use kahan_core::nalgebra::{SMatrix, SVector};

use kahan_core::{Dd, FloatScalar, QuadraticField};

use super::norm;

/// A scalar that flows are computed in, with the length of its series: `f64` or [`Dd`].
pub(crate) trait Digits: FloatScalar + From<f64> + From<Dd> + Into<Dd> {
    /// The terms beyond x₀: cost falls with the number of steps and grows with its square, so the
    /// least lies near the number of digits.
    const TERMS: usize = if Self::SHORT_BITS > f64::SHORT_BITS { 30 } else { 18 };

    /// A step as a part of the radius of convergence ρ: the first term left out is about
    /// (h/ρ)^(TERMS + 1) of the solution, 0.14¹⁹ ≈ 6·10⁻¹⁷ and 0.09³¹ ≈ 4·10⁻³³.
    const PART_OF_RADIUS: f64 = if Self::SHORT_BITS > f64::SHORT_BITS { 0.09 } else { 0.14 };
}

impl<T: FloatScalar + From<f64> + From<Dd> + Into<Dd>> Digits for T {}

/// A field with what its series need beyond it.
#[derive(Clone, Debug)]
pub(super) struct Expansion<'a, F, T, const N: usize> {
    field: &'a F,
    linear: SMatrix<T, N, N>,
    constant: SVector<T, N>,
}

/// The series at one point, and how far it serves.
#[derive(Clone, Debug)]
pub(super) struct Series<T, const N: usize> {
    /// x₀, x₁, …, the coefficients of powers of rate·(t − t₀).
    pub(super) coefficients: Vec<SVector<T, N>>,
    pub(super) rate: f64,
    /// The radius of convergence, estimated from the last coefficients; infinite where they are 0.
    pub(super) radius: f64,
    /// How fast the velocity turns, ‖ẍ‖/‖ẋ‖ in the maximum norm; 0 at rest.
    pub(super) turning: f64,
}

impl<'a, T: Digits, F: QuadraticField<T, N>, const N: usize> Expansion<'a, F, T, N> {
    pub(super) fn of(field: &'a F) -> Self {
        let origin = SVector::repeat(T::zero());
        Self { field, linear: field.field_jacobian(&origin), constant: field.field(&origin) }
    }

    /// The series at x₀, whose radius of convergence is about 1/`rate`, or else is found in some
    /// more trials. Cost: about TERMS²/4 evaluations of the bilinear form.
    pub(super) fn at(&self, start: SVector<T, N>, rate: f64) -> Series<T, N> {
        /// What the 30th power of keeps far from the ends of the range.
        const NEAR: f64 = (1_u64 << 16) as f64;
        const TRIALS: usize = 16;
        let mut rate = power_of_two(rate);
        let mut series = self.in_units(start, rate);
        for _ in 0..TRIALS {
            let size = series.radius * rate;
            if (1.0 / NEAR..=NEAR).contains(&size) || norm(&series.coefficients[1]) == 0.0 {
                break;
            }
            // Coefficients that are too large, or too small to be seen, say only in which
            // direction.
            rate = power_of_two(match size {
                size if size == f64::INFINITY => rate / NEAR,
                size if size > 0.0 => rate / size,
                _ => rate * NEAR,
            });
            let other = self.in_units(start, rate);
            if size == f64::INFINITY && other.radius == f64::INFINITY {
                // A polynomial in t.
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
            // Q is symmetric: each pair once.
            for i in 0..k.div_ceil(2) {
                sum += self.field.bilinear(&series[i], &series[k - i]).map(|entry| two * entry);
            }
            if k % 2 == 0 {
                sum += self.field.bilinear(&series[k / 2], &series[k / 2]);
            }
            // A power of 2 that comes last: what is scaled is neither too large nor too small.
            let divisor = T::from((k + 1) as f64);
            series.push(sum.map(|entry| entry * unit / divisor));
        }
        let (speed, bend) = (norm(&series[1]), norm(&series[2]));
        let turning = if speed > 0.0 { 2.0 * bend / speed * rate } else { 0.0 };
        let radius = radius(&series) / rate;
        Series { coefficients: series, rate, radius, turning }
    }
}

impl<T: Digits, const N: usize> Series<T, N> {
    /// How far the series may be used.
    pub(super) fn reach(&self) -> f64 {
        T::PART_OF_RADIUS * self.radius
    }

    /// x(t₀ + s).
    pub(super) fn value(&self, s: T) -> SVector<T, N> {
        let (s, zero) = (s * T::from(self.rate), SVector::repeat(T::zero()));
        self.coefficients.iter().rev().fold(zero, |sum, coefficient| sum.map(|entry| entry * s) + coefficient)
    }
}

/// ρ from |xₖ| ~ |x₀|ρ⁻ᵏ in the last two terms, as Jorba and Zou, Exp. Math. 14 (2005) 99, have it,
/// but component by component: one that is small now may decide later, so it is small errors of
/// itself that count.
///
/// A step h = pρ, p the [part](Digits::PART_OF_RADIUS), leaves out about |x_K|h^K where p^K of
/// the component is allowed. The component is at least as large as each of its terms |xₖ|hᵏ, and
/// may begin with 0: the term that allows the longest step counts.
fn radius<T: Digits, const N: usize>(series: &[SVector<T, N>]) -> f64 {
    let size = |k: usize, i: usize| series[k][i].approximate().abs();
    let estimate = |i: usize, last: usize| {
        let (left_out, allowed) = (size(last, i), T::PART_OF_RADIUS.powi(last as i32));
        if !left_out.is_finite() {
            // Beyond the range.
            return 0.0;
        }
        let step = |k: usize| (allowed * (size(k, i) / left_out)).powf(1.0 / (last - k) as f64);
        let longest = (0..=last / 2).map(step).fold(0.0, f64::max);
        if left_out > 0.0 { longest / T::PART_OF_RADIUS } else { f64::INFINITY }
    };
    let last = series.len() - 1;
    (0..N).map(|i| estimate(i, last).min(estimate(i, last - 1))).fold(f64::INFINITY, f64::min)
}

/// The power of 2 nearest to a rate, within a range whose products do not overflow; 1 where nothing
/// moves, or it is no number.
fn power_of_two(rate: f64) -> f64 {
    let exponent = rate.log2().round();
    if exponent.is_finite() { exponent.clamp(-400.0, 400.0).exp2() } else { 1.0 }
}

fn times<T: Digits, const N: usize>(matrix: &SMatrix<T, N, N>, x: &SVector<T, N>) -> SVector<T, N> {
    SVector::from_fn(|i, _| (0..N).fold(T::zero(), |sum, j| sum + matrix[(i, j)] * x[j]))
}
