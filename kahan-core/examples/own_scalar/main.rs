//! A user-defined scalar. Over complex numbers, an orbit goes around a pole of its solution.
//!
//! The solution x(t) = tan t has a pole at π/2. A half circle in complex time leads from 0 around
//! the pole to 3.

mod complex;

use kahan_core::nalgebra;
use kahan_core::prelude::*;

use complex::Complex;

kahan! {
    struct Tangent;
    xdot = 1 + x^2;
}

/// Returns 3/2 + 3/2·exp(iθ). As `fraction` grows from 0 to 1, θ falls from π to 0.
fn time(fraction: f64) -> nalgebra::Complex<f64> {
    let (sine, cosine) = (std::f64::consts::PI * (1.0 - fraction)).sin_cos();
    nalgebra::Complex::new(1.5 + 1.5 * cosine, 1.5 * sine)
}

/// Prints and returns x at the end of the path, and the exact value tan 3.
pub(crate) fn run() -> [nalgebra::Complex<f64>; 2] {
    let mut x = vector![Complex(0.0.into())];
    for step in 0..1_000 {
        let [from, to] = [step, step + 1].map(|step| time(f64::from(step) / 1_000.0));
        x = Tangent.step(&x, Complex((to - from) / 2.0)); // eps is half the time step
    }
    let [end, expected] = [x[0].0, 3.0_f64.tan().into()];
    println!("round the pole: {end:.6}, and tan 3 = {expected:.6}");
    [end, expected]
}

fn main() {
    run();
}
