//! A block at module level needs a header; only rustc knows the level.

use kahan_core::prelude::*;

kahan! {
    xdot = y;
    ydot = -x;
}

fn main() {}
