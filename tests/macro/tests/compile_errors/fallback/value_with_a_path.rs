//! A value in a block without a header must be a plain name, not a field such as `self.mu`.

use kahan_core::prelude::*;

struct Model {
    mu: f64,
}

impl Model {
    fn next(&self, x: &SVector<f64, 1>) -> SVector<f64, 1> {
        kahan! { xdot = self.mu*x^2; }.step(x, 0.1)
    }
}

fn main() {
    Model { mu: 0.5 }.next(&vector![1.0]);
}
