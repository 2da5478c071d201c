//! Which of the two is 0?

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { k, l }
    xdot = k*y;
    ydot = -l*x;
    integral H = y when k*l = 0;
}

fn main() {}
