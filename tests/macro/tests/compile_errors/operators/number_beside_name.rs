//! `2x`, as one token.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    xdot = 1 + 2x;
}

fn main() {}
