//! Every entry ends with `;`.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    bracket P { {x,y} = 1 }
}

fn main() {}
