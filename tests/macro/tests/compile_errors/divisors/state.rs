//! A quotient of states is not polynomial.

use kahan_core::prelude::*;

kahan! {
    pub struct Kepler;
    xdot = y/x;
    ydot = 1;
}

fn main() {}
