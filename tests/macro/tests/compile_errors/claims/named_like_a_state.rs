//! A name means one thing.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral x = x^2 + y^2;
}

fn main() {}
