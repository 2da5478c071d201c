//! A root is no polynomial.

use kahan_core::prelude::*;

kahan! {
    pub struct Root;
    xdot = x^1.5;
}

fn main() {}
