//! Without a step everything is conserved.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral H = x*y when eps = 0;
}

fn main() {}
