//! A name means one thing.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    const c = 2;
    const c = 3;
    xdot = c*x;
}

fn main() {}
