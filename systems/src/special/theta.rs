//! The theta functions ϑ₁, ϑ₂, ϑ₃ and ϑ₄ of a real argument, by series in the nome.

use super::Real;
use super::gamma::not_a_number;

/// The values of ϑ₁ to ϑ₄ at one argument z, for one nome q.
#[derive(Clone, Debug, PartialEq)]
pub struct Theta<T> {
    /// The value ϑ₁ = 2Σ_{n≥0} (−1)ⁿ q^((n+1/2)²) sin (2n+1)z.
    pub one: T,
    /// The value ϑ₂ = 2Σ_{n≥0} q^((n+1/2)²) cos (2n+1)z.
    pub two: T,
    /// The value ϑ₃ = 1 + 2Σ_{n≥1} q^(n²) cos 2nz.
    pub three: T,
    /// The value ϑ₄ = 1 + 2Σ_{n≥1} (−1)ⁿ q^(n²) cos 2nz.
    pub four: T,
}

/// Returns the four theta functions at z for the nome 0 ≤ q < 1, or NaN for other q. A precision of
/// D digits takes √(D ln 10/ln(1/q)) terms: 4 for q = 0.1 in `f64`, and 40 for q = 0.9 in
/// [`Float256`](super::Float256). In `f64`, for q ≤ 0.9 and |z| ≤ 10, the error is at most 10 units
/// of 2⁻⁵² max(1, |ϑ|).
///
/// ```
/// use kahan_systems::special::theta;
///
/// let (at_zero, q) = (theta(&0.0, &0.1), 0.1_f64);
/// // Jacobi: ϑ₃⁴ = ϑ₂⁴ + ϑ₄⁴
/// assert!((at_zero.three.powi(4) - at_zero.two.powi(4) - at_zero.four.powi(4)).abs() < 1e-14);
/// assert!((at_zero.three - (1.0 + 2.0 * q + 2.0 * q.powi(4) + 2.0 * q.powi(9))).abs() < 1e-15);
/// ```
pub fn theta<T: Real>(z: &T, q: &T) -> Theta<T> {
    if q.is_negative() || *q >= T::one() || !q.is_finite_number() {
        let none = not_a_number();
        return Theta { one: none, two: none, three: none, four: none };
    }
    let (sine, cosine) = z.sin_cos();
    let mut sum = Theta { one: T::zero(), two: T::zero(), three: T::one(), four: T::one() };
    if q.is_zero() {
        return sum;
    }
    // Each pass rotates (s, c) by z. Chebyshev's recurrence for sin jz loses digits near z = 0.
    let (mut s, mut c) = (T::zero(), T::one());
    let quarter = q.sqrt().sqrt();
    // The powers are q^(j²/4) for j = 0, 1, 2, …. The ratio of neighbours is q^((2j+1)/4).
    let (mut power, mut ratio) = (T::one(), quarter);
    let root = q.sqrt();
    for j in 1.. {
        (s, c) = (s * cosine + c * sine, c * cosine - s * sine);
        power *= ratio;
        ratio *= root;
        let term = T::from_int(2) * power;
        let alternating = |value: T| if j / 2 % 2 == 0 { value } else { -value };
        if j % 2 == 1 {
            sum.one += alternating(term * s);
            sum.two += term * c;
        } else {
            sum.three += term * c;
            sum.four += alternating(term * c);
        }
        // The bound is proportional to `quarter` = q^(1/4), as are the first terms of ϑ₁ and ϑ₂.
        // Therefore ϑ₁ and ϑ₂ stay precise for small q.
        if term < T::epsilon() * T::half() * quarter {
            break;
        }
    }
    sum
}
