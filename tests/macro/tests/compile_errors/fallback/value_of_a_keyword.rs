//! Undeclared names take the values of variables around the block, but `self` is a keyword.

use kahan_core::prelude::*;

fn main() {
    let field = kahan! { xdot = -self*x; };
    let _: SVector<f64, 1> = field.step(&vector![1.0], 0.1);
}
