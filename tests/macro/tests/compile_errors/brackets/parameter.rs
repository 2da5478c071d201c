//! A parameter does not move.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { w }
    xdot = w*y;
    ydot = -w*x;
    bracket P { {x,w} = 1; }
}

fn main() {}
