//! `eps` is the half time step.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral eps = x^2 + y^2;
}

fn main() {}
