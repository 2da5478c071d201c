//! A `;` that ends nothing.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    xdot = x;;
}

fn main() {}
