//! A claim speaks of states, parameters, `eps` and earlier claims.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral H = x^2 + y^2 + z^2;
}

fn main() {}
