//! Keywords are no parameters.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation { k }
    xdot = k*y;
    ydot = -k*super;
}

fn main() {}
