//! The flow keeps it, the map a deformation of it.

use kahan_core::prelude::*;

kahan! {
    pub struct E6;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
    integral H = x*z + y^2;
}

fn main() {}
