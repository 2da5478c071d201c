//! `when` fixes a value.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { k, l }
    xdot = k*y;
    ydot = -l*x;
    integral H = x^2 + y^2 when k = l;
}

fn main() {}
