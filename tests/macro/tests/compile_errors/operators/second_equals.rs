//! One equation, two `=`.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y = 0;
    ydot = -x;
}

fn main() {}
