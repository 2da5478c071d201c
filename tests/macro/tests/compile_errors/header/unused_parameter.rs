//! A parameter without effect is a slip.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k, l }
    xdot = -k*x;
}

fn main() {}
