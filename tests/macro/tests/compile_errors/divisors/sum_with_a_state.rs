//! The whole divisor counts.

use kahan_core::prelude::*;

kahan! {
    pub struct Saturation { k }
    xdot = -x/(k + x);
}

fn main() {}
