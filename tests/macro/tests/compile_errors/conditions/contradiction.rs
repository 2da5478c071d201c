//! Which of the two?

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { k }
    xdot = k*y;
    ydot = -k*x;
    integral H = x^2 + y^2 when k = 1, k = 2;
}

fn main() {}
