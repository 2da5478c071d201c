//! Zero, in figures.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay;
    xdot = -x/0;
}

fn main() {}
