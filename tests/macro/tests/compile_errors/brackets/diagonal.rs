//! A bracket is antisymmetric.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    bracket P { {x,x} = 1; {x,y} = 1; }
}

fn main() {}
