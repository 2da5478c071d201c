//! The third relation says nothing that the first two do not.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { k, l, m }
    xdot = k*y;
    ydot = -l*x;
    zdot = m;
    integral H = x^2 + y^2 when k = m, m = l, k*m = l*m;
}

fn main() {}
