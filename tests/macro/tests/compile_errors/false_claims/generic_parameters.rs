//! True at xi = 1 only.

use kahan_core::prelude::*;

kahan! {
    pub struct E7 { xi }
    xdot = -x^2;
    ydot = -xi*x*y;
    zdot = 2*xi*y^2 + x*z;
    integral H = y/x;
}

fn main() {}
