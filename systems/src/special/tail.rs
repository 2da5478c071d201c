//! Sums series from an index N to infinity by asymptotic expansions. Integrals of the maps of E7
//! and E8 contain these series.
//!
//! Let w_j = N + j + 1/2 for j ≥ 0. The summands are Σ_i w_j^(−s−2i)(a_i + b_i ln w_j + c_i ln²
//! w_j) with coefficients a_i, b_i, c_i. The Euler–Maclaurin formula for midpoints gives the sum of
//! each power: Σ_j w_j^(−s) = N^(1−s) [1/(s−1) + Σ_{k≥1} B₂ₖ(1/2) s(s+1)…(s+2k−2)/((2k)! N^(2k))].
//! Its derivatives with respect to s give the sums with logarithms. The code expands the formula at
//! s + η in powers of η up to η²; such a polynomial is called a jet.

use super::Real;
use super::gamma::asymptotic_from;
use super::gamma_ratio::{binomial_sum, middle_values};

/// A jet z₀ + z₁η + z₂η², where η³ = 0.
type Jet<T> = [T; 3];

/// Returns an N at which the expansions are precise: `size` is ξ for E7, and 0 for E8.
pub(crate) fn asymptotic_start<T: Real>(size: &T) -> i64 {
    2 * asymptotic_from::<T>() + 4 * size.abs().to_f64().ceil() as i64
}

/// Returns the number of powers that the expansions need for N from [`asymptotic_start`] on.
fn order<T: Real>() -> usize {
    T::DIGITS / 2 + 5
}

/// Returns Σ_{j≥0} 4ξ Y_j Y_{j+1}/((4(N+j)² − 1)(2(N+j) + 3)) with Y_j = 1/R(N + j, σ), σ = (ξ −
/// 1)/2 and R(w, σ) = Γ(w + 1/2 + σ)/Γ(w + 1/2 − σ). Requires ξ > 0 and N ≥ [`asymptotic_start`].
///
/// Let w = N + j + 1/2, and p_n(σ) = B_n(σ) + n σ^(n−1)/2 with the Bernoulli polynomial B_n. The
/// term with index j is ξ/(2w(w² − 1)) · w^(−4σ) exp Σ_m 2p_{2m+1}(σ)/(m(2m+1) w^(2m)).
pub(crate) fn gamma_product_tail<T: Real>(n: &T, xi: &T) -> T {
    let sigma = (*xi - T::one()) * T::half();
    let numbers: Vec<T> = core::iter::once(T::one()).chain(T::bernoulli().iter().copied()).collect();
    let exponents = (1..=order::<T>() as i64)
        .map(|m| T::from_int(2) * binomial_sum(2 * m + 1, &sigma, &numbers) / T::from_int(m * (2 * m + 1)));
    let exponent: Vec<T> = core::iter::once(T::zero()).chain(exponents).collect();
    let coefficients = divide_by_one_minus_square(exponential(&exponent));
    let terms: Vec<Jet<T>> = coefficients.into_iter().map(|a| [a, T::zero(), T::zero()]).collect();
    *xi * T::half() * tail(n, &(T::from_int(2) * *xi + T::one()), &terms)
}

/// Returns the sum Σ_{j≥0} 2(Y_j + Y_{j+1} + 2Y_jY_{j+1})/((4(N+j)² − 1)(2(N+j) + 3)). Here Y_j =
/// `h` − ψ(N + j + 1/2) with the digamma function ψ. Requires N ≥ [`asymptotic_start`].
///
/// With w = N + j + 1/2, Bernoulli numbers B₂ₘ, and D = h + Σ B₂ₘ/(2m w^(2m)) − ln w, the term with
/// index j is (D + D² − 1/(4w²))/(2w(w² − 1)).
pub(crate) fn digamma_product_tail<T: Real>(n: &T, h: &T) -> T {
    let even: Vec<T> = core::iter::once(*h)
        .chain((1..).zip(T::bernoulli()).map(|(m, number)| *number / T::from_int(2 * m)))
        .take(order::<T>() + 1)
        .collect();
    let mut constant = product(&even, &even);
    for (value, term) in constant.iter_mut().zip(&even) {
        *value += *term;
    }
    constant[1] -= T::from_ratio(1, 4);
    let mut linear: Vec<T> = even.into_iter().map(|value| -(T::from_int(2) * value)).collect();
    linear[0] -= T::one();
    let mut square = vec![T::zero(); order::<T>() + 1];
    square[0] = T::one();
    let [constant, linear, square] = [constant, linear, square].map(divide_by_one_minus_square);
    let terms: Vec<Jet<T>> =
        constant.into_iter().zip(linear).zip(square).map(|((a, b), c)| [a, b, c]).collect();
    T::half() * tail(n, &T::from_int(3), &terms)
}

/// Returns Σ_{j≥0} Σ_i w^(−s−2i)(a_i + b_i ln w + c_i ln² w), where w = N + 1/2 + j. `coefficients`
/// are the a_i, b_i and c_i.
fn tail<T: Real>(n: &T, s: &T, coefficients: &[Jet<T>]) -> T {
    let middle = middle_values::<T>();
    let inverse_square = T::one() / n.square();
    let logarithm = n.ln();
    // With η³ = 0, N^(1−s−η) = N^(1−s)(1 − η ln N + η² ln² N/2).
    let power: Jet<T> = [T::one(), -logarithm, logarithm.square() * T::half()];
    let mut scale = T::one();
    let mut sum = T::zero();
    for (i, [a, b, c]) in coefficients.iter().enumerate() {
        let exponent = *s + T::from_int(2 * i as i64);
        let series = power_sum(&exponent, &inverse_square, &middle[..coefficients.len() - i]);
        let [z0, z1, z2] = multiply(power, series);
        // −d/ds multiplies w^(−s) by ln w. Hence −z1 is the sum with ln w, and 2·z2 that with ln²
        // w.
        sum += scale * (*a * z0 - *b * z1 + T::from_int(2) * *c * z2);
        scale *= inverse_square;
    }
    sum * n.power_real(&(T::one() - *s))
}

/// Returns 1/(s+η−1) + Σ_{k≥1} B₂ₖ(1/2) (s+η)…(s+η+2k−2)/(2k)! · v^k as a jet in η, where v =
/// N^(−2).
fn power_sum<T: Real>(s: &T, v: &T, middle: &[T]) -> Jet<T> {
    let inverse = T::one() / (*s - T::one());
    let mut sum = [inverse, -inverse.square(), inverse.power(3)];
    let factor = |shift: i64| [*s + T::from_int(shift), T::one(), T::zero()];
    let mut term = factor(0).map(|value| value * *v * T::half());
    for (k, value) in (1..).zip(&middle[1..]) {
        for (total, part) in sum.iter_mut().zip(&term) {
            *total += *part * *value;
        }
        let divisor = T::from_int((2 * k + 1) * (2 * k + 2));
        term = multiply(multiply(term, factor(2 * k - 1)), factor(2 * k)).map(|value| value * *v / divisor);
    }
    sum
}

fn multiply<T: Real>([a0, a1, a2]: Jet<T>, [b0, b1, b2]: Jet<T>) -> Jet<T> {
    [a0 * b0, a0 * b1 + a1 * b0, a0 * b2 + a1 * b1 + a2 * b0]
}

/// Multiplies two power series. The result has as many terms as the first series.
fn product<T: Real>(a: &[T], b: &[T]) -> Vec<T> {
    (0..a.len()).map(|n| (0..=n).fold(T::zero(), |sum, i| sum + a[i] * b[n - i])).collect()
}

/// Returns the exponential of a power series Σ cₘ vᵐ without constant term. The coefficients are eₙ
/// with n eₙ = Σ m cₘ eₙ₋ₘ.
fn exponential<T: Real>(series: &[T]) -> Vec<T> {
    let mut result = vec![T::one()];
    for n in 1..series.len() {
        let sum = (1..=n).fold(T::zero(), |sum, m| sum + T::from_int(m as i64) * series[m] * result[n - m]);
        result.push(sum / T::from_int(n as i64));
    }
    result
}

/// Divides a power series in w⁻² by 1 − w⁻².
fn divide_by_one_minus_square<T: Real>(series: Vec<T>) -> Vec<T> {
    let mut total = T::zero();
    let sum = |value| {
        total += value;
        total
    };
    series.into_iter().map(sum).collect()
}
