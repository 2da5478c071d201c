//! Tests the accuracy of tangent vectors for long steps, compared with double-double. The code
//! generator rejects a formula if its median error exceeds 450 units of roundoff and is more than
//! 45 times that of elimination with pivoting.

use kahan_algebra::prime_field::SplitMix64;
use kahan_core::prelude::*;
use kahan_core::{Dd, ExtendScalars};
use kahan_tests::rounding::UNIT_F64;

kahan! {
    /// Rates of positions are momenta, so eliminating positions by diagonal pivots is accurate.
    struct HenonHeiles;
    xdot = p; ydot = q; pdot = -x - 2*x*y; qdot = y^2 - x^2 - y;
}

kahan! {
    /// Five variables. Eliminating independent states by diagonal pivots would lose ten digits.
    struct Five;
    adot = b*c; bdot = c*d - a; cdot = d*e - b*a; ddot = e*a + c; edot = a*b - d^2;
}

kahan! {
    /// A field of two blocks. The states x and y of the first block drive z and w.
    struct Driven;
    xdot = x - y*x; ydot = x*y - y; zdot = z*x - z*y + x; wdot = w*z - x*w + z;
}

/// Returns the median error of tangent vectors over points with ‖εf′‖∞ = `size`.
fn median_error<M: ExtendScalars<f64, N>, const N: usize>(map: &M, size: f64) -> f64 {
    const POINTS: usize = 301;
    let mut random = SplitMix64::new(7);
    let mut drawn = || SVector::<f64, N>::from_fn(|_, _| random.below(1 << 20) as f64 / 2e5 - 2.5);
    let mut errors: Vec<f64> = (0..POINTS)
        .map(|_| {
            let (x, v) = (drawn(), drawn());
            let slopes = map.field_jacobian(&x);
            let norm = slopes.row_iter().map(|row| row.iter().map(|entry| entry.abs()).sum::<f64>());
            let eps = size / norm.fold(0.0, f64::max);
            let next = map.step(&x, eps);
            let carried = map.at(eps).tangent().push_forward_to(&x, &next, &v).expect("a float has a value");
            let wide = map.extend_scalars(|parameter| Dd::from(*parameter));
            let [x, v] = [x, v].map(|entries| entries.map(Dd::from));
            let exact = (wide.jacobian(&x, Dd::from(eps)) * v).map(|entry| entry.approximate());
            (carried - exact).amax() / (UNIT_F64 * exact.amax())
        })
        .collect();
    errors.sort_by(f64::total_cmp);
    errors[POINTS / 2]
}

#[test]
fn forms_that_lose_digits_in_long_steps_are_refused() {
    for size in [1.0, 10.0, 100.0, 1000.0] {
        let medians =
            [median_error(&HenonHeiles, size), median_error(&Five, size), median_error(&Driven, size)];
        assert!(medians.iter().all(|median| *median <= 450.0), "{medians:?} at {size}");
    }
}
