//! A slip in the name of the parameter.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { omega }
    xdot = omega*y;
    ydot = -omega*x;
    integral H = x^2 + y^2 when omgea = 1;
}

fn main() {}
