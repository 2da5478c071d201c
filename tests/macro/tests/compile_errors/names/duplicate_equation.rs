//! One equation a state.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    xdot = -y;
}

fn main() {}
