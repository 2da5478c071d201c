//! The points have dimension two, but the map has dimension three.

use kahan_core::prelude::*;

kahan! {
    pub struct E6;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
}

fn main() {
    let mut points = Ensemble::new(vec![vector![1.0, 2.0]]);
    points.advance(&E6.at(0.1), 10);
}
