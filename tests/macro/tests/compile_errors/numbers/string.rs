//! Text is no number.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay;
    xdot = -"2"*x;
}

fn main() {}
