//! Rust's power, of a sum.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    xdot = (x - 1).powi(2);
}

fn main() {}
