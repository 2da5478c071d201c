//! In an equation a quotient is written as one.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k }
    xdot = -k^-1*x;
}

fn main() {}
