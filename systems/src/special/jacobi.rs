//! Computes Jacobi's elliptic functions sn, cn and dn of a real argument.

use super::gamma::not_a_number;
use super::{Modulus, Real};

/// The values of sn, cn and dn at one argument.
#[derive(Clone, Debug, PartialEq)]
pub struct Jacobi<T> {
    /// The value sn(u, k), which is the sine of the amplitude.
    pub sn: T,
    /// The value cn(u, k), which is the cosine of the amplitude.
    pub cn: T,
    /// The value dn(u, k) = √(1 − k² sn²) ≥ 0.
    pub dn: T,
}

/// Returns sn u, cn u and dn u for real u and a modulus 0 ≤ k ≤ 1, by Landen's descending
/// transformation. In `f64` the errors are at most 8 units of 2⁻⁵² for |u| ≤ 2K and k ≤ 0.999, and
/// 64 units for larger k < 1. For larger u, the rounding of u adds to the error.
///
/// ```
/// use kahan_systems::special::{Modulus, jacobi};
///
/// let value = jacobi(&0.5, &Modulus::new(0.0));
/// assert!((value.sn - 0.5_f64.sin()).abs() < 1e-15 && value.dn == 1.0);
/// ```
pub fn jacobi<T: Real>(u: &T, modulus: &Modulus<T>) -> Jacobi<T> {
    if modulus.complement.is_zero() {
        let secant = T::one() / u.cosh();
        return Jacobi { sn: u.tanh(), cn: secant, dn: secant };
    }
    if !modulus.complement.is_positive() {
        return Jacobi { sn: not_a_number(), cn: not_a_number(), dn: not_a_number() };
    }
    let half_period = T::from_int(2) * modulus.quarter_period();
    let turns = (*u / half_period + T::half()).floor();
    let rest = *u - turns * half_period;
    let Jacobi { sn, cn, dn } = descend(&rest, modulus);
    let odd = (turns * T::half()).floor() * T::from_int(2) != turns;
    if odd { Jacobi { sn: -sn, cn: -cn, dn } } else { Jacobi { sn, cn, dn } }
}

/// Applies one step of Landen's transformation. With k₁ = (1 − k′)/(1 + k′), the values for the
/// modulus k are
///
///   sn = (1 + k₁)s/(1 + k₁s²), cn = cd/(1 + k₁s²), dn = (1 − k₁ + k₁c²)/(1 + k₁s²),
///
/// where s, c and d are sn, cn and dn at u/(1 + k₁) for the modulus k₁.
fn descend<T: Real>(u: &T, modulus: &Modulus<T>) -> Jacobi<T> {
    // For small k, sn u = sin u + O(k²) and dn u = 1 − O(k²).
    if modulus.k.square() < T::epsilon() * T::from_ratio(1, 16) {
        let (sn, cn) = u.sin_cos();
        return Jacobi { sn, cn, dn: T::one() };
    }
    let sum = T::one() + modulus.complement;
    // 1 − k′ = k²/(1 + k′), without cancellation.
    let lower = Modulus {
        k: (modulus.k / sum).square(),
        complement: T::from_int(2) * modulus.complement.sqrt() / sum,
    };
    let Jacobi { sn: s, cn: c, dn: d } = descend(&(*u * sum * T::half()), &lower);
    let divisor = T::one() + lower.k * s.square();
    // 1 − k₁ = 2k′/(1 + k′), 1 + k₁ = 2/(1 + k′)
    let two = T::from_int(2);
    Jacobi {
        sn: two * s / (sum * divisor),
        dn: (two * modulus.complement / sum + lower.k * c.square()) / divisor,
        cn: c * d / divisor,
    }
}
