//! The second density is an integral in disguise.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x;
    density rho = 1;
    density sigma = x^2 + y^2;
}

fn main() {}
