//! Each equation is read whatever happened to the ones before it.

use kahan_core::prelude::*;

kahan! {
    pub struct Three { k }
    xdot = -sin(x);
    ydot = 2y - k;
    zdot = x*y*z;
}

fn main() {}
