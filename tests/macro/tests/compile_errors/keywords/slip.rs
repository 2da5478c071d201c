//! A slip.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integrl H = x^2 + y^2;
}

fn main() {}
