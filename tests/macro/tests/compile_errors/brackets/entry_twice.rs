//! {y,x} is −{x,y}.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    bracket P { {x,y} = 1; {y,x} = -1; }
}

fn main() {}
