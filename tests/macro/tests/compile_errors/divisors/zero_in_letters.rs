//! Zero, after expansion.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k }
    xdot = -x/(k*(k + 1) - k^2 - k);
}

fn main() {}
