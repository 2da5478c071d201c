//! States at which elimination without exchanges of rows would lose all digits: pivots that are 0,
//! or nearly so, are left to partial pivoting.

use kahan_core::prelude::*;

use super::systems::Ring;

/// The ring at ε = 1/2 with xᵢ₊₁ − xᵢ₋₁ = 2 + δ for i = 0: the first pivot is −δ/2.
fn state(delta: f64) -> SVector<f64, 12> {
    let mut x = SVector::from_fn(|i, _| 1.0 + 0.25 * f64::from(i as u32 % 3));
    x[1] = x[11] + 2.0 + delta;
    x
}

/// A change of δ by 2⁻⁴⁰ moves x̃ by some thousand times as much at most, and nothing is lost
/// besides: elimination by a pivot of 2⁻⁴¹ would lose 40 bits.
#[test]
fn a_pivot_near_zero_costs_no_digits() {
    let next = Ring.step(&state(0.0), 0.5);
    for power in [-20, -30, -40, -45, -50] {
        let delta = f64::from(power).exp2();
        let moved = (Ring.step(&state(delta), 0.5) - next).amax();
        assert!(moved <= 1e3 * delta + 1e-12, "2^{power}: {moved:e}");
    }
}
