//! States move.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral H = x^2 + y^2 when x = 1;
}

fn main() {}
