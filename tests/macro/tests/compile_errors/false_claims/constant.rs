//! True, and says nothing.

use kahan_core::prelude::*;

kahan! {
    pub struct E1;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = 3;
}

fn main() {}
