//! An indexed parameter is no name.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k }
    xdot = -k[0]*x;
}

fn main() {}
