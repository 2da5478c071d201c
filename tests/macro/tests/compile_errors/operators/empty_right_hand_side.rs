//! A state at rest is written `xdot = 0;`.

use kahan_core::prelude::*;

kahan! {
    pub struct Rest;
    xdot = ;
}

fn main() {}
