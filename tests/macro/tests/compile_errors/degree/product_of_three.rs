//! The third factor raises the degree.

use kahan_core::prelude::*;

kahan! {
    pub struct Cubic;
    xdot = y*z;
    ydot = -x*y*z;
    zdot = x;
}

fn main() {}
