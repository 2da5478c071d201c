//! The vector has two entries, but the map has dimension three.

use kahan_core::prelude::*;

kahan! {
    pub struct E6;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
}

fn main() {
    E6.step(&vector![1.0, 2.0], 0.1);
}
