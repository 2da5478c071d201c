//! A relation behind `when` is solved for one of its names.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { k, l }
    xdot = k*y;
    ydot = -l*x;
    integral H = x^2 + y^2 when k^2 = l^2 + 1;
}

fn main() {}
