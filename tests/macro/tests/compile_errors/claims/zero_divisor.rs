//! Zero, in figures.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral H = (x^2 + y^2)/0;
}

fn main() {}
