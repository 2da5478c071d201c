//! The sum cancels the squares, not the cubes.

use kahan_core::prelude::*;

kahan! {
    pub struct Cubic;
    xdot = (x + y)*(x - y)*y - x^2 + y^2;
    ydot = x;
}

fn main() {}
