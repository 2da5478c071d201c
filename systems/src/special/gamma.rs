//! Γ and ψ of [`Float256`](super::Float256). An asymptotic series gives Γ(x + n) or ψ(x + n) for
//! large n, and a recurrence leads back to x. For x < 1/2, a reflection leads to 1 − x first.
//! Floats use other crates (see [`Real::gamma`]).

use super::Real;

/// Returns Γ(x), or NaN at the poles 0, −1, −2, …. For `f64` the error is at most 8 ulp on (−30,
/// 171). For [`Float256`](super::Float256) the relative error is below 1e−72 for |x| ≤ 1000.
///
/// ```
/// use kahan_systems::special::{Float256, Real, gamma};
///
/// let half = Float256::half();
/// assert!((gamma(&half).square() - Float256::pi()).abs() < Float256::from_ratio(1, 10).power(70));
/// assert_eq!(gamma(&6.0), 120.0);
/// ```
pub fn gamma<T: Real>(x: &T) -> T {
    x.gamma()
}

/// Returns ψ(x) = Γ′(x)/Γ(x), or NaN at the poles 0, −1, −2, …. For `f64` the error is at most 2⁻⁴⁸
/// max(1, |ψ|) for x > −30. For [`Float256`](super::Float256) the error is below 1e−73·max(1, |ψ|)
/// for |x| ≤ 1000.
///
/// ```
/// use kahan_systems::special::{Float256, Real, digamma};
///
/// // ψ(x + 1) = ψ(x) + 1/x
/// let x = Float256::from_ratio(3, 7);
/// let step = digamma(&(x.clone() + Float256::from_int(1))) - digamma(&x);
/// assert!((step - Float256::from_ratio(7, 3)).abs() < Float256::from_ratio(1, 10).power(70));
/// ```
pub fn digamma<T: Real>(x: &T) -> T {
    x.digamma()
}

/// Returns whether x is one of the poles 0, −1, −2, … of Γ and ψ.
pub(super) fn is_pole<T: Real>(x: &T) -> bool {
    !x.is_positive() && x.floor() == *x
}

/// Returns the least argument x at which Stirling's series reaches full precision.
pub(super) fn asymptotic_from<T: Real>() -> i64 {
    5 + (T::DIGITS as i64 * 45) / 100
}

/// Returns how many times 1 must be added to x > 0 to reach at least `from`.
pub(super) fn steps_up<T: Real>(x: &T, from: i64) -> i64 {
    ((T::from_int(from) - *x).to_f64().ceil() as i64).max(0)
}

/// Returns sin(πx). The argument is reduced exactly before it is multiplied by π.
pub(super) fn sin_pi<T: Real>(x: &T) -> T {
    let turns = T::from_int(2) * (*x * T::half() + T::half() * T::half()).floor();
    let rest = *x - turns;
    (T::pi() * rest).sin()
}

/// Returns cos(πx). The argument is reduced exactly, so that zeros are exact.
pub(super) fn cos_pi<T: Real>(x: &T) -> T {
    let two = T::from_int(2);
    let rest = *x - two * (*x * T::half() + T::half()).floor();
    // The variable `rest` lies in [−1, 1). Where the cosine is small, 1/2 − |rest| is exact.
    (T::pi() * (T::half() - rest.abs())).sin()
}

/// Returns Γ(x) = √(2π) x^(x−1/2) e^(−x) exp Σ B₂ₘ/(2m(2m−1) x^(2m−1)) with Bernoulli numbers B₂ₘ.
/// The series is used at a large x + n, and Γ(x+1) = xΓ(x) leads back to x. For x < 1/2, Γ(x)Γ(1−x)
/// = π/sin πx is used.
pub(super) fn by_stirling<T: Real>(x: &T) -> T {
    if is_pole(x) || !x.is_finite_number() {
        return not_a_number();
    }
    if *x < T::half() {
        return T::pi() / (sin_pi(x) * by_stirling(&(T::one() - *x)));
    }
    let steps = steps_up(x, asymptotic_from::<T>());
    let mut descent = T::one();
    for j in 0..steps {
        descent *= *x + T::from_int(j);
    }
    let large = *x + T::from_int(steps);
    let series = stirling_sum(&large, |m, bernoulli| bernoulli / T::from_int(2 * m * (2 * m - 1))) * large;
    let power = large.power_real(&(large - T::half()));
    (T::from_int(2) * T::pi()).sqrt() * power * (series - large).exp() / descent
}

/// Returns ψ(x) = ln x − 1/(2x) − Σ B₂ₘ/(2m x^(2m)) with Bernoulli numbers B₂ₘ. The series is used
/// at a large x + n, and ψ(x+1) = ψ(x) + 1/x leads back to x. For x < 1/2, ψ(x) = ψ(1−x) − π cot πx
/// is used.
pub(super) fn digamma_by_stirling<T: Real>(x: &T) -> T {
    if is_pole(x) || !x.is_finite_number() {
        return not_a_number();
    }
    if *x < T::half() {
        let cotangent = sin_pi(&(*x + T::half())) / sin_pi(x);
        return digamma_by_stirling(&(T::one() - *x)) - T::pi() * cotangent;
    }
    let steps = steps_up(x, asymptotic_from::<T>());
    let mut descent = T::zero();
    for j in 0..steps {
        descent += T::one() / (*x + T::from_int(j));
    }
    let large = *x + T::from_int(steps);
    let series = stirling_sum(&large, |m, bernoulli| bernoulli / T::from_int(2 * m));
    large.ln() - T::half() / large - series - descent
}

/// Returns the sum Σ_{m≥1} term(m, B₂ₘ) x^(−2m) to the precision of T.
fn stirling_sum<T: Real>(x: &T, term: impl Fn(i64, T) -> T) -> T {
    sum_in_inverse_squares(x, (1..).zip(T::bernoulli()).map(|(m, bernoulli)| term(m, *bernoulli)))
}

/// Returns the sum Σ_{m≥1} cₘ x^(−2m) of terms with these coefficients cₘ, to the precision of T.
pub(super) fn sum_in_inverse_squares<T: Real>(x: &T, coefficients: impl Iterator<Item = T>) -> T {
    let inverse_square = T::one() / x.square();
    let mut power = T::one();
    let mut sum = T::zero();
    for coefficient in coefficients {
        power *= inverse_square;
        let next = coefficient * power;
        let small = next.abs() < T::epsilon() * sum.abs() * T::half();
        sum += next;
        if small {
            break;
        }
    }
    sum
}

pub(super) fn not_a_number<T: Real>() -> T {
    T::zero() / T::zero()
}
