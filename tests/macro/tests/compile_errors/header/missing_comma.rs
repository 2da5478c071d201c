//! Parameters are separated by `,`.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k l }
    xdot = -k*x - l;
}

fn main() {}
