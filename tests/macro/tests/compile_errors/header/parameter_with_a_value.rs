//! A value is given where the system is built.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k = 2 }
    xdot = -k*x;
}

fn main() {}
