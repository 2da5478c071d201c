//! The map was not prepared by `at`, so its time step is not known.

use kahan_core::prelude::*;

kahan! {
    pub struct E6;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
}

fn main() {
    let mut points = Ensemble::new(vec![vector![1.0, 2.0, 3.0]]);
    points.advance(&E6, 1000);
}
