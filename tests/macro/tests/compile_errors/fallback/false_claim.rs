//! A false claim still has an accessor.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral H = x*y;
}

fn main() {
    let _: SVector<f64, 1> = Rotation.integrals(&vector![1.0, 2.0], 0.1);
}
