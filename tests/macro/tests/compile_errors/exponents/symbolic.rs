//! The degree is known while compiling, so an exponent is a number.

use kahan_core::prelude::*;

kahan! {
    pub struct Power { n }
    xdot = x^n;
}

fn main() {}
