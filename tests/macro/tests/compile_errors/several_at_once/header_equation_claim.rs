//! One mistake in each part of the block.

use kahan_core::prelude::*;

kahan! {
    pub struct Parts { k: f64 }
    xdot = -k**x;
    ydot = x;
    integral H x^2;
}

fn main() {}
