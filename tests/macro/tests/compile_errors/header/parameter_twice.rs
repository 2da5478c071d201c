//! One parameter, one field.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k, k }
    xdot = -k*x;
}

fn main() {}
