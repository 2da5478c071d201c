//! `x (y + 1)` would be a call in Rust.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth { k }
    xdot = k (x + 1);
}

fn main() {}
