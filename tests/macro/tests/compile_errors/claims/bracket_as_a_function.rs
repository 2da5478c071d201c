//! A bracket has no value.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    bracket P { {x,y} = 1; }
    integral H = P*(x^2 + y^2);
}

fn main() {}
