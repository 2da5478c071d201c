//! The field itself divides by zero there.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { k }
    xdot = y/k;
    ydot = -x/k;
    integral H = x^2 + y^2 when k = 0;
}

fn main() {}
