//! The left-hand side is the derivative.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    x = y;
    ydot = -x;
}

fn main() {}
