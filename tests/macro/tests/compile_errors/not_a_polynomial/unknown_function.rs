//! A product in the mathematician's way, a call in Rust's.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth { k }
    xdot = k(x + 1);
}

fn main() {}
