//! `3 x`, as two tokens.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    xdot = 1 + 3 x;
}

fn main() {}
