//! The macro reads text, not the result of another macro.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay;
    xdot = -rate!()*x;
}

fn main() {}
