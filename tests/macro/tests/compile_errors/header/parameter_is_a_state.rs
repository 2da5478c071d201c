//! A name is a state or a parameter.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k, x }
    xdot = -k*x;
}

fn main() {}
