//! A method is no operation on polynomials.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay;
    xdot = -x.abs();
}

fn main() {}
