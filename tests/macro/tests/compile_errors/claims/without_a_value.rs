//! A claim says something.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    integral H = ;
}

fn main() {}
