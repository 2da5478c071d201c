//! A system is a struct.

use kahan_core::prelude::*;

kahan! {
    pub enum Decay { k }
    xdot = -k*x;
}

fn main() {}
