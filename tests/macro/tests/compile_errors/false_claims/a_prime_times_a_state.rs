//! Zero modulo 2^61 - 1, and false.

use kahan_core::prelude::*;

kahan! {
    pub struct E1;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = 2305843009213693951*x;
}

fn main() {}
