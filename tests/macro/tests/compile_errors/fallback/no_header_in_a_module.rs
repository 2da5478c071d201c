//! At the level of a module a block needs a header; rustc alone knows that it stands there.

use kahan_core::prelude::*;

kahan! {
    xdot = y;
    ydot = -x;
}

fn main() {}
