//! Every state has an equation.

use kahan_core::prelude::*;

kahan! {
    pub struct Predator;
    xdot = x*(1 - z);
}

fn main() {}
