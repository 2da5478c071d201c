//! The time must be declared as a state or parameter, and a derivative is no name.

use kahan_core::prelude::*;

kahan! {
    pub struct Driven;
    xdot = v;
    vdot = t - x;
}

fn main() {
    let _ = kahan! {
        xdot = v;
        vdot = t - x - xdot;
    };
}
