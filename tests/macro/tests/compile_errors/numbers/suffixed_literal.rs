//! A suffix names a type, and numbers here have none.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay;
    xdot = -2f64*x;
}

fn main() {}
