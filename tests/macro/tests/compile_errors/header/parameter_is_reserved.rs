//! `eps` is the half time step.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { eps }
    xdot = -eps*x;
}

fn main() {}
