//! Numbers are decimal.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay;
    xdot = -0x1F*x;
}

fn main() {}
