//! Half time steps ε with so few bits that their squares and cubes are exact.

use crate::FloatScalar;

/// Returns the number nearest to `eps` with at most a third of the scalar's bits: 8 for `f32`, 17
/// for `f64`, 35 for `Dd`. Square and cube of the result are exact.
///
/// A step may use ε, ε² and ε³, each computed once and rounded. If the rounded ε² is not the square
/// of the rounded ε, the step is not Kahan's step for any ε. This error is equal in every step.
/// Therefore integrals drift in proportion to the number of steps, even in compensated orbits.
/// Exact powers avoid this drift.
///
/// The drift matters after about 10⁷ steps in `f64`, or 10⁵ steps in `f32`, if the step multiplies
/// parameters by powers of ε. The integrals of the Euler top drift at ε = 0.05, but not at ε =
/// 3/64. The result differs from `eps` by a relative 2⁻¹⁷ at most, in `f32` by 2⁻⁸.
///
/// A short ε does not help if the product of a parameter and ε is rounded, or in compositions,
/// whose stages have other step sizes. For a homogeneous field
/// [`Orbit::scaled`](crate::Orbit::scaled) removes ε altogether. Infinities and NaN are returned
/// unchanged. A subnormal ε keeps fewer bits.
///
/// ```
/// use kahan_core::nearest_short_eps;
///
/// let eps = nearest_short_eps(0.05_f64);
/// assert!((eps - 0.05).abs() <= 0.05 / f64::from(1 << 17));
/// assert_eq!(nearest_short_eps(3.0 / 64.0), 3.0 / 64.0);
/// ```
pub fn nearest_short_eps<T: FloatScalar>(eps: T) -> T {
    eps.nearest_short()
}
