//! Claims are read in order.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral K = H^2;
    integral H = x^2 + y^2;
}

fn main() {}
