//! Tests states with zero and tiny pivots, for which elimination needs row exchanges.

use kahan_core::prelude::*;

use super::systems::Ring;

/// Returns a state of the ring with x₁ − x₁₁ = 2 + δ. For ε = 1/2 the first pivot is −δ/2.
fn state(delta: f64) -> SVector<f64, 12> {
    let mut x = SVector::from_fn(|i, _| 1.0 + 0.25 * f64::from(i as u32 % 3));
    x[1] = x[11] + 2.0 + delta;
    x
}

/// For δ = 2⁻⁴⁰ the first pivot is −2⁻⁴¹. Elimination with it loses 40 bits, but the result must
/// not.
#[test]
fn a_pivot_near_zero_costs_no_digits() {
    let next = Ring.step(&state(0.0), 0.5);
    for power in [-20, -30, -40, -45, -50] {
        let delta = f64::from(power).exp2();
        let moved = (Ring.step(&state(delta), 0.5) - next).amax();
        assert!(moved <= 1e3 * delta + 1e-12, "2^{power}: {moved:e}");
    }
}
