//! Half steps that rounding treats well.
//!
//! In: the ε that one would like. Out: one near it whose powers are exact.

use crate::FloatScalar;

/// The number nearest to `eps` that has at most a third of the scalar's bits (`f32`: 8, `f64`: 17,
/// `Dd`: 35), so that its square and cube are exact.
///
/// Why one wants that: a step may use ε, ε² and ε³, each computed once and rounded. A rounded ε is
/// still some ε, and its map keeps its own integrals. But the rounded ε² is not the square of the
/// rounded ε, so the step belongs to no ε at all; its error is the same in every step, and the
/// integrals drift in proportion to the number of steps, in compensated orbits, too. Where the
/// powers are exact there is no such drift.
///
/// When it matters: in long runs (from about 10⁷ steps in `f64`, 10⁵ in `f32`) of systems whose
/// step multiplies parameters with powers of ε, as the Euler top's does: its integrals drift at
/// ε = 0.05, and not at ε = 3/64. What it costs: the result differs from `eps` by at most 2⁻¹⁷ of
/// it (`f32`: 2⁻⁸), nothing for a time step that was chosen freely.
///
/// When it does not help: where a parameter's product with ε is rounded, and in compositions, whose
/// stages have steps of their own. For a homogeneous field [`Orbit::scaled`](crate::Orbit::scaled)
/// removes ε altogether. Infinities and NaN are returned as they are; a subnormal ε keeps fewer
/// bits.
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
