//! A field does not know the step.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    xdot = eps*x;
}

fn main() {}
