//! Rust's power.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    xdot = x.powi(2) - x;
}

fn main() {}
