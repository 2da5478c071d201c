//! `2.` is a number, but before a name the point reads as the access to a field.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay;
    xdot = 1 - 2.x;
}

fn main() {}
