//! Every claim is judged.

use kahan_core::prelude::*;

kahan! {
    pub struct E1;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = y/x;
    integral K = x*z + y^2;
    density rho = 1/x;
    bracket P { {x,y} = 1; }
}

fn main() {}
