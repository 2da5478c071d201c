//! Quadratic, squared.

use kahan_core::prelude::*;

kahan! {
    pub struct Quartic;
    xdot = 1 + (x^2 + y)^2;
    ydot = x;
}

fn main() {}
