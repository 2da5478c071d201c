//! Every item ends with `;`; the next equation is still read.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y
    ydot = -x;
}

fn main() {}
