//! A bracket has entries.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    bracket P = 1;
}

fn main() {}
