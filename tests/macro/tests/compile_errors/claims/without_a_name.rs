//! A claim is called by its name.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral = x^2 + y^2;
}

fn main() {}
