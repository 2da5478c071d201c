//! An entry is a pair of states.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    bracket P { {x,z} = 1; }
}

fn main() {}
