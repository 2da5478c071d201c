//! A degree that needs more points than usual.

use kahan_core::prelude::*;

kahan! {
    pub struct E1;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = y/x*z^60;
}

fn main() {}
