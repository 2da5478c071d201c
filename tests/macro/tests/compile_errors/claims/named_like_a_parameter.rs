//! A name means one thing.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { w }
    xdot = w*y;
    ydot = -w*x;
    integral w = x^2 + y^2;
}

fn main() {}
