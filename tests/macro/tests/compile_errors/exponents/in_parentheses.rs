//! An exponent is written without parentheses.

use kahan_core::prelude::*;

kahan! {
    pub struct Power;
    xdot = x^(1+1);
}

fn main() {}
