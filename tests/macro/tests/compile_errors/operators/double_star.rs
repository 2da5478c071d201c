//! Python's power.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    xdot = x**2;
}

fn main() {}
