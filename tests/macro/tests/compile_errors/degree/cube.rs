//! A cubic term.

use kahan_core::prelude::*;

kahan! {
    pub struct Cubic;
    xdot = x^3 - x;
}

fn main() {}
