//! Lebesgue measure is invariant under the flow, not under the map.

use kahan_core::prelude::*;

kahan! {
    pub struct E6;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
    density rho = 1;
}

fn main() {}
