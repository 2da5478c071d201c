//! Claims are rational.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral H = sqrt(x^2 + y^2);
}

fn main() {}
