//! With h = 2 eps for eps.

use kahan_core::prelude::*;

kahan! {
    pub struct E1;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral K = (x*z + y^2)/(1 - 4*eps^2*x^2);
}

fn main() {}
