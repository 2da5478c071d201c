//! Each trajectory has a map, but `at` was not called, so the time steps are not known.

use kahan_core::prelude::*;

kahan! {
    pub struct E6;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
}

fn main() {
    let maps = vec![E6; 2];
    let mut points = Ensemble::new(vec![vector![1.0, 2.0, 3.0], vector![1.0, 1.0, 2.0]]);
    points.advance(&maps, 1000);
}
