//! The nearest name is suggested.

use kahan_core::prelude::*;

kahan! {
    pub struct Damped { omega }
    xdot = y;
    ydot = -omgea*x;
}

fn main() {}
