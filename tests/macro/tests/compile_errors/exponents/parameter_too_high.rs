//! Powers of parameters are expanded, so they are limited.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k }
    xdot = -k^65*x;
}

fn main() {}
