//! Names differ by their case.

use kahan_core::prelude::*;

kahan! {
    pub struct Damped { Omega }
    xdot = y;
    ydot = -omega*x;
}

fn main() {}
