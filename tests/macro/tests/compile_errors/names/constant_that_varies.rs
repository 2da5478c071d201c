//! Constants are known while compiling.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth { k }
    const c = 2*k;
    xdot = c*k*x;
}

fn main() {}
