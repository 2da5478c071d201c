//! Zero, by a constant.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay;
    const c = 1/2 - 0.5;
    xdot = -x/c;
}

fn main() {}
