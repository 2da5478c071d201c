//! Without a value at any point, which only evaluation shows.

use kahan_core::prelude::*;

kahan! {
    pub struct E1;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = x/((x + y)^2 - x^2 - 2*x*y - y^2);
}

fn main() {}
