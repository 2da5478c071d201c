//! The counterexample satisfies the relation.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { k, l }
    xdot = k*y;
    ydot = -l*x;
    integral H = x^2 + y^2 when k = 2*l;
}

fn main() {}
