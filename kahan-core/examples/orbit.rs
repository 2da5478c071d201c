//! An orbit of a freely rotating rigid body over ten thousand steps, and its integrals.
//!
//! Kahan's map of the Euler top has two proved integrals, which only rounding changes.

use kahan_core::prelude::*;

kahan! {
    /// The angular velocity of a body in its principal axes.
    struct EulerTop { a, b, c }
    xdot = a*y*z;
    ydot = b*z*x;
    zdot = c*x*y;
    integral F = (1 - eps^2*c*a*y^2)/(1 - eps^2*a*b*z^2);
    integral G = (1 - eps^2*a*b*z^2)/(1 - eps^2*b*c*x^2);
}

/// Prints every thousandth point. Returns the largest change of any integral along the orbit.
pub(crate) fn run() -> f64 {
    let top = EulerTop { a: 1.0, b: -2.0, c: 1.0 };
    let (start, eps) = (vector![1.0, 0.01, 0.5], 0.05); // eps is half the time step
    let first = top.integrals(&start, eps);
    let mut largest: f64 = 0.0;
    for (step, x) in top.orbit(start, eps).take(10_001).enumerate() {
        largest = largest.max((top.integrals(&x, eps) - first).amax());
        if step % 1_000 == 0 {
            println!("t = {:6.1}   x = {:+.6}   y = {:+.6}   z = {:+.6}", step as f64 * 0.1, x.x, x.y, x.z);
        }
    }
    println!("the integrals changed by {largest:.1e} at most");
    largest
}

fn main() {
    run();
}
