//! One slip in a left-hand side, one error: the uses of `x` are right.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdto = y;
    ydot = -x;
}

fn main() {}
