//! A product needs its `*`, also between parentheses.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    xdot = (x - 1)(x + 1);
}

fn main() {}
