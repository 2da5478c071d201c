//! A header ends with `;` or its parameters.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay
    xdot = -x;
}

fn main() {}
