//! The time is used without being declared, and a derivative is used as a name.

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
