//! The transcendental integrals of the map of E8.

use kahan_core::nalgebra::SVector;

use crate::solution::{OutOfDomain, require, square_less_one};
use crate::special::{Real, asymptotic_start, digamma, digamma_product_tail};

/// Returns Ĥ₈ = y/x + ψ(1/2 + u) with u = 1/(2εx), an integral of the map of E8 (Hone and Petrera,
/// Section 6.2). The result is NaN for x = 0 and at poles of ψ.
pub fn integral_h<T: Real>(point: &SVector<T, 3>, eps: &T) -> T {
    let level = T::one() / (T::from_int(2) * *eps * point[0]);
    point[1] / point[0] + digamma(&(level + T::half()))
}

/// Returns K̂₈, the second integral of the map of E8. With N = 1/(2εx), Y_0 = y/x and Y_{j+1} = Y_j
/// − 1/(N+j+1/2), the integral is given by
///
/// ε²K̂₈ = (z/x)/(4N²−1) + Σ_{j≥0} 2(Y_j + Y_{j+1} + 2Y_jY_{j+1})/((4(N+j)²−1)(2(N+j)+3)).
///
/// In `f64`, terms are added up to N + j ≈ 22. In [`Float256`](crate::special::Float256), they are
/// added up to 78. An asymptotic expansion gives the sum of the others. For εx < 0, N is negative,
/// and about |N| more terms are added. Fails if εx = 0.
pub fn integral_k<T: Real>(point: &SVector<T, 3>, eps: &T) -> Result<T, OutOfDomain> {
    let [x, y, z] = (*point).into();
    let scaled = T::from_int(2) * *eps * x;
    require(!scaled.is_zero(), "eps x != 0")?;
    let two = T::from_int(2);
    let mut level = T::one() / scaled;
    let mut slope = y / x;
    let start: T = T::from_int(asymptotic_start(&T::zero()));
    let mut sum = z / (x * square_less_one(level));
    while level < start {
        let next = slope - T::one() / (level + T::half());
        let top = slope + next + two * slope * next;
        sum += two * top / (square_less_one(level) * (two * level + T::from_int(3)));
        slope = next;
        level += T::one();
    }
    let integral_h = slope + digamma(&(level + T::half()));
    Ok((sum + digamma_product_tail(&level, &integral_h)) / eps.square())
}
