//! Decimal exponents are limited, so that no literal fills the memory.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay;
    xdot = -1e5000*x;
}

fn main() {}
