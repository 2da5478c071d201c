//! Another word for an integral; what uses it is no second mistake.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    invariant H = x^2 + y^2;
    integral G = 2*H;
}

fn main() {}
