//! A product needs its `*`, also between names.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth { k }
    xdot = k x;
}

fn main() {}
