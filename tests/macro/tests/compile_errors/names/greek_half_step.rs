//! The lunate epsilon is another letter.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral H = (x^2 + y^2)*(1 + ϵ^2);
}

fn main() {}
