//! A block holds one system.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    xdot = x;
    pub struct Decay;
    ydot = -y;
}

fn main() {}
