//! The integrals of the map of E7, which are transcendental for generic ξ, and its bracket with
//! digamma functions.

use kahan_core::nalgebra::{SMatrix, SVector};

use crate::solution::{OutOfDomain, require, square_less_one};
use crate::special::{
    Real, asymptotic_start, centered_digamma_difference, centered_gamma_ratio, gamma_product_tail,
};

/// Returns u = 1/(2εx), which increases by 1 in each step of the map.
fn level<T: Real>(x: &T, eps: &T) -> T {
    T::one() / (T::from_int(2) * *eps * *x)
}

/// Returns σ = (ξ − 1)/2, for which Γ(u + ξ/2)/Γ(u + 1 − ξ/2) = Γ(u + ½ + σ)/Γ(u + ½ − σ).
fn sigma<T: Real>(xi: &T) -> T {
    (*xi - T::one()) * T::half()
}

/// Returns Ĥ₇ = (y/x) Γ(ξ/2 + u)/Γ(1 − ξ/2 + u) with u = 1/(2εx), an integral of the map of E7
/// (Hone and Petrera, Section 6.1). Ĥ₇ equals y/x for ξ = 1, and 4ε²xy/(1 − ε²x²) for ξ = −1. The
/// result is NaN for x = 0, and zero or infinite at poles of Γ.
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_systems::{E7, e7};
///
/// let (xi, eps) = (0.7, 0.25);
/// let start = vector![0.5, 1.0, -0.25];
/// let next = E7 { xi }.step(&start, eps);
/// let [before, after] = [start, next].map(|point| e7::integral_h(&xi, &point, &eps));
/// assert!((after / before - 1.0).abs() < 1e-14);
/// ```
pub fn integral_h<T: Real>(xi: &T, point: &SVector<T, 3>, eps: &T) -> T {
    let ratio = centered_gamma_ratio(&level(&point[0], eps), &sigma(xi));
    point[1] / point[0] * ratio
}

/// Returns K̂₇, the second integral of the map of E7, for ξ > 0. With N = 1/(2εx), Y_0 = y/x and
/// Y_{j+1} = Y_j (N+j+1−ξ/2)/(N+j+ξ/2), the integral is given by
///
/// ε²K̂₇ = (z/x)/(4N²−1) + Σ_{j≥0} 4ξ Y_jY_{j+1}/((4(N+j)²−1)(2(N+j)+3)).
///
/// At ξ = 1 it equals (xz + y²)/(1 − ε²x²). In `f64`, terms are added up to N + j ≈ 22 + 4ξ. In
/// [`Float256`](crate::special::Float256), they are added up to 78 + 4ξ. An asymptotic expansion
/// gives the sum of the others. For εx < 0, N is negative, and about |N| more terms are added.
/// Fails if ξ ≤ 0, where the series diverges, or if εx = 0.
pub fn integral_k<T: Real>(xi: &T, point: &SVector<T, 3>, eps: &T) -> Result<T, OutOfDomain> {
    let [x, y, z] = (*point).into();
    require(xi.is_positive(), "xi > 0")?;
    require(!(x * *eps).is_zero(), "eps x != 0")?;
    let mut level = level(&x, eps);
    let mut slope = y / x;
    let half_xi = *xi * T::half();
    let two = T::from_int(2);
    let start: T = T::from_int(asymptotic_start(xi));
    let mut sum = z / (x * square_less_one(level));
    while level < start {
        let next = slope * (level + T::one() - half_xi) / (level + half_xi);
        sum += two * two * *xi * slope * next / (square_less_one(level) * (two * level + T::from_int(3)));
        slope = next;
        level += T::one();
    }
    let integral_h = slope * centered_gamma_ratio(&level, &sigma(xi));
    Ok((sum + integral_h.square() * gamma_product_tail(&level, xi)) / eps.square())
}

/// Returns the antisymmetric matrix of the invariant bracket {x_i, x_j} of the map of E7 with the
/// Casimir function Ĥ₇ (Hone and Petrera, Section 6.1). With u = 1/(2εx), the entries are
///
///   {x,y} = 0, {z,x} = x(1 − ε²x²), {y,z} = y(1 − ε²x²)[(ψ(1 − ξ/2 + u) − ψ(ξ/2 + u))/(2εx) − 1].
///
/// For ξ = 1 the matrix is the negative of E1's `P`. For ξ = −1 it is the negative of E2's `P`.
pub fn bracket_of_h<T: Real>(xi: &T, point: &SVector<T, 3>, eps: &T) -> SMatrix<T, 3, 3> {
    let [x, y, _] = (*point).into();
    let scaled = *eps * x;
    let width = (T::one() - scaled) * (T::one() + scaled);
    let level = level(&x, eps);
    let difference = -centered_digamma_difference(&level, &sigma(xi));
    let yz = y * width * (difference * level - T::one());
    let zx = x * width;
    let zero = T::zero();
    SMatrix::from_row_slice(&[zero, zero, -zx, zero, zero, yz, zx, -yz, zero])
}
