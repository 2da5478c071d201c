//! An entry is a pair of states.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    bracket P { {x,y,x} = 1; }
}

fn main() {}
