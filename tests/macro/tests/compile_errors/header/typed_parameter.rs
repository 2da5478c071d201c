//! The macro gives every parameter the scalar's type.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { k: f64 }
    xdot = -k*x;
}

fn main() {}
