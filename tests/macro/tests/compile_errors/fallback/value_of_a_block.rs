//! A block in expression position still has a value.

use kahan_core::prelude::*;

fn main() {
    let mu = 0.5_f64;
    let field = kahan! {
        xdot = mu*x*y;
        ydot = x - y^3;
    };
    let next: SVector<f64, 2> = field.step(&vector![1.0, 2.0], 0.1);
    let _ = field.jacobian(&next, 0.1);
}
