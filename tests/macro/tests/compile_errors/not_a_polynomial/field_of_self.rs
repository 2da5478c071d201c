//! Parameters are named, not reached for.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k }
    xdot = -self.k*x;
}

fn main() {}
