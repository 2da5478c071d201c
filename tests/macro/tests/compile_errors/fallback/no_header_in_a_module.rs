//! Only rustc knows that a block is outside of functions, so rustc reports the missing header.

use kahan_core::prelude::*;

kahan! {
    xdot = y;
    ydot = -x;
}

fn main() {}
