//! Parameters become fields of a struct.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { type }
    xdot = -type*x;
}

fn main() {}
