//! A left-hand side without `dot` is still read as a state, so the dimension is right.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    x = y;
    ydot = -x;
    integral H = x^2 + y^2;
}

fn main() {
    let _: SVector<f64, 2> = Rotation.step(&vector![1.0, 2.0], 0.1);
}
