//! Parameters do not count, states do.

use kahan_core::prelude::*;

kahan! {
    pub struct VanDerPol { mu }
    xdot = y;
    ydot = mu*(1 - x^2)*y - x;
}

fn main() {}
