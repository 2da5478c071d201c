//! A name means one thing.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral H = x^2 + y^2;
    integral H = 2*x^2 + 2*y^2;
}

fn main() {}
