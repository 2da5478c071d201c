//! Undeclared names are variables around the block. Here rustc does not find such a variable.

use kahan_core::prelude::*;

fn main() {
    let omega = 0.5_f64;
    let field = kahan! {
        xdot = omega*y;
        ydot = -omgea*x;
    };
    let _: SVector<f64, 2> = field.step(&vector![1.0, 2.0], 0.1);
}
