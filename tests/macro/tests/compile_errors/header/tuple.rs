//! Parameters have names.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay(k);
    xdot = -k*x;
}

fn main() {}
