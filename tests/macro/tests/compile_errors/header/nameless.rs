//! A type needs a name.

use kahan_core::prelude::*;

kahan! {
    pub struct;
    xdot = -x;
}

fn main() {}
