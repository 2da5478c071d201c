//! Ratios of Γ and differences of ψ at the arguments w + 1/2 ± σ, without cancellation for large w.
//! The logarithm of R(w, σ) = Γ(w + 1/2 + σ)/Γ(w + 1/2 − σ) has an asymptotic series in 1/w, with
//! Bernoulli polynomials B_{2m+1} as coefficients: ln R = 2σ ln w − Σ_{m≥1} B_{2m+1}(1/2 +
//! σ)/(m(2m+1) w^(2m)).

use super::Real;
use super::gamma::{asymptotic_from, cos_pi, sin_pi, steps_up, sum_in_inverse_squares};

/// Returns Γ(x + a)/Γ(x + b) for real x, a, b, with full relative precision for all sizes of x. If
/// only the denominator has a pole, the result is zero; if only the numerator has one, NaN; if both
/// have one, the limit. [`centered_gamma_ratio`] avoids the rounding of (a + b − 1)/2 and (a −
/// b)/2.
///
/// ```
/// use kahan_systems::special::gamma_ratio;
///
/// assert_eq!(gamma_ratio(&1e15, &1.0, &0.0), 1e15);
/// assert_eq!(gamma_ratio(&-3.0, &1.0, &0.0), -3.0);
/// ```
pub fn gamma_ratio<T: Real>(x: &T, a: &T, b: &T) -> T {
    let middle = (*a + *b - T::one()) * T::half();
    centered_gamma_ratio(&(*x + middle), &((*a - *b) * T::half()))
}

/// Returns the centred ratio R(w, σ) = Γ(w + 1/2 + σ)/Γ(w + 1/2 − σ) for real w and σ.
///
/// If 2σ is an integer with |2σ| ≤ 64, R or its reciprocal is a polynomial, which is evaluated.
/// Otherwise a series gives R at a larger argument, and a recurrence leads back to w. The
/// recurrence has at most about 12 + 2|σ| factors (40 + 2|σ| for [`Float256`](super::Float256)).
///
/// In `f64`, for |σ| ≤ 3, the error is at most 4 ulp for w ≥ 20, and 40 ulp for 0 ≤ w ≤ 20. For
/// −20 ≤ w < 0 the error is at most 64 ulp away from the poles.
pub fn centered_gamma_ratio<T: Real>(w: &T, sigma: &T) -> T {
    if let Some(n) = small_integer(&(T::from_int(2) * *sigma)) {
        return rational_ratio(w, n);
    }
    if is_reflected(w, sigma) {
        return reflection(w, sigma) * centered_gamma_ratio(&-*w, sigma);
    }
    let steps = steps_up(w, asymptotic_from::<T>() + 2 * sigma.abs().to_f64().ceil() as i64);
    let mut numerator = T::one();
    let mut denominator = T::one();
    for j in 0..steps {
        let centre = *w + (T::from_int(j) + T::half());
        numerator *= centre - *sigma;
        denominator *= centre + *sigma;
    }
    let large = *w + T::from_int(steps);
    let series = odd_bernoulli_sum(&large, sigma, |m, value| value / T::from_int(m * (2 * m + 1)));
    large.power_real(&(T::from_int(2) * *sigma)) * (-series).exp() * (numerator / denominator)
}

/// Returns ψ(w + 1/2 + σ) − ψ(w + 1/2 − σ) for real w and σ away from the poles. The relative
/// precision is full even where both terms are nearly equal.
///
/// ```
/// use kahan_systems::special::centered_digamma_difference;
///
/// // ψ(w + 1) − ψ(w) = 1/w
/// assert_eq!(centered_digamma_difference(&1e15, &0.5), 1e-15);
/// ```
pub fn centered_digamma_difference<T: Real>(w: &T, sigma: &T) -> T {
    let two = T::from_int(2);
    if is_reflected(w, sigma) {
        let fold = fold(w);
        let cosines = cos_pi(&(*sigma - fold)) * cos_pi(&(*sigma + fold));
        let tangents = T::pi() * sin_pi(&(two * *sigma)) / cosines;
        return tangents - centered_digamma_difference(&-*w, sigma);
    }
    let steps = steps_up(w, asymptotic_from::<T>() + 2 * sigma.abs().to_f64().ceil() as i64);
    let mut descent = T::zero();
    for j in 0..steps {
        let centre = *w + (T::from_int(j) + T::half());
        descent += T::one() / ((centre - *sigma) * (centre + *sigma));
    }
    let large = *w + T::from_int(steps);
    let series = odd_bernoulli_sum(&large, sigma, |m, value| value / T::from_int(2 * m + 1)) / large;
    two * (*sigma / large + series + *sigma * descent)
}

/// Returns whether w is so negative that the reflection is used.
fn is_reflected<T: Real>(w: &T, sigma: &T) -> bool {
    *w < -(sigma.abs() + T::half())
}

fn fold<T: Real>(w: &T) -> T {
    *w - (*w + T::half()).floor()
}

/// Returns R(w, σ)/R(−w, σ) = cos π(σ − f)/cos π(σ + f) for the centred ratio R, where f is w minus
/// the nearest integer. This follows from Γ(z)Γ(1−z) = π/sin πz.
fn reflection<T: Real>(w: &T, sigma: &T) -> T {
    let fold = fold(w);
    cos_pi(&(*sigma - fold)) / cos_pi(&(*sigma + fold))
}

fn small_integer<T: Real>(x: &T) -> Option<i64> {
    let n = x.to_f64();
    (n.abs() <= 64.0 && x.floor() == *x).then_some(n as i64)
}

/// Returns the centred ratio R(w, n/2). For n ≥ 0 it is the product of w + (1−n)/2 + j over 0 ≤ j <
/// n; for n < 0 it is the reciprocal of R(w, −n/2).
fn rational_ratio<T: Real>(w: &T, n: i64) -> T {
    let product =
        (0..n.abs()).fold(T::one(), |product, j| product * (*w + T::from_ratio(1 - n.abs() + 2 * j, 2)));
    if n < 0 { T::one() / product } else { product }
}

/// Returns the sum Σ_{m≥1} term(m, B_{2m+1}(1/2 + σ)) w^(−2m) to the precision of T. The Bernoulli
/// polynomials are B_n(1/2 + σ) = Σ_k C(n, k) B_k(1/2) σ^(n−k) with B_k(1/2) = (2^(1−k) − 1) B_k.
fn odd_bernoulli_sum<T: Real>(w: &T, sigma: &T, term: impl Fn(i64, T) -> T) -> T {
    let middle = middle_values::<T>();
    let terms = 1..=T::bernoulli().len() as i64;
    sum_in_inverse_squares(w, terms.map(|m| term(m, binomial_sum(2 * m + 1, sigma, &middle))))
}

/// Returns the sum of C(n, k) vₖ σ^(n−k) over even k < n, for odd n, by Horner's scheme. `values`
/// are v₀, v₂, v₄, ….
pub(super) fn binomial_sum<T: Real>(n: i64, sigma: &T, values: &[T]) -> T {
    let square = sigma.square();
    let mut binomial = T::one();
    let mut sum = T::zero();
    for (k, value) in (0..n).step_by(2).zip(values) {
        sum = sum * square + binomial * *value;
        binomial = binomial * T::from_int((n - k) * (n - k - 1)) / T::from_int((k + 1) * (k + 2));
    }
    sum * *sigma
}

/// Returns the values B₀(1/2), B₂(1/2), B₄(1/2), … of Bernoulli polynomials.
pub(super) fn middle_values<T: Real>() -> Vec<T> {
    let mut power = T::from_int(2);
    let quarter = T::from_ratio(1, 4);
    core::iter::once(T::one())
        .chain(T::bernoulli().iter().map(|bernoulli| {
            power *= quarter;
            (power - T::one()) * *bernoulli
        }))
        .collect()
}
