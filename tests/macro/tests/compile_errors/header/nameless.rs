//! A type has a name.

use kahan_core::prelude::*;

kahan! {
    pub struct;
    xdot = -x;
}

fn main() {}
