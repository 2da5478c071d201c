//! Another word for a bracket.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    poisson P { {x,y} = 1; }
    integral H = x^2 + y^2;
}

fn main() {}
