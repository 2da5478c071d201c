//! Entries are checked one by one.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    bracket P { {x,x} = 1; {x,z} = 1; {y,x} = w; {x,y} = 1; }
}

fn main() {}
