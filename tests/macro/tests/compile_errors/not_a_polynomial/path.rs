//! A path is no name.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay;
    xdot = -physics::RATE*x;
}

fn main() {}
