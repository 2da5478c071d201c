//! Powers in claims are limited to 64, so that the proof stays quick.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral H = (x^2 + y^2)^65;
}

fn main() {}
