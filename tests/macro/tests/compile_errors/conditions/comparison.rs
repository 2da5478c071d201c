//! `when` fixes a value, it does not test one.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { k }
    xdot = k*y;
    ydot = -k*x;
    integral H = x^2 + y^2 when k > 0;
}

fn main() {}
