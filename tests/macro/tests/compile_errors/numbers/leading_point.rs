//! `.5` is no number in Rust.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay;
    xdot = -.5*x;
}

fn main() {}
