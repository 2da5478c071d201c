//! Half steps that rounding treats well.
//!
//! In: the ε that one would like. Out: one near it whose powers are exact.

use crate::FloatScalar;

/// The ε nearest to `eps` with at most a third of the scalar's bits (`f32`: 8, `f64`: 17, `Dd`: 35), so that ε² and ε³ are exact.
///
/// The map at a rounded ε is as good as any other, but where the step computes powers of ε their roundings are the same in every
/// step: together they are no ε at all, and the integrals of the map drift linearly with the number of steps, compensated
/// or not. It matters for long runs (from about 10⁷ steps in `f64`, 10⁵ in `f32`), for systems whose step has powers of ε times
/// parameters (the Euler top) and for an ε near a simple rational: at ε = 0.05 the Euler top's integrals drift linearly even
/// when compensated, at 3/64 they do not. The nearest short ε differs from the wish by at most 2⁻¹⁷ of it (`f32`: 2⁻⁸), which
/// for a step that was chosen freely costs nothing.
///
/// It does not help where parameters are rounded and multiplied with ε, nor in a composition, whose stages take γε; for a
/// homogeneous field [`Orbit::scaled`](crate::Orbit::scaled) removes ε altogether. What is not finite is returned as it is; a subnormal ε keeps fewer bits.
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
