//! A name means one thing.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    const x = 2;
    xdot = x;
}

fn main() {}
