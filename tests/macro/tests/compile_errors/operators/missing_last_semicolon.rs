//! The last item ends with `;` as well.

use kahan_core::prelude::*;

kahan! {
    pub struct Rotation;
    xdot = y;
    ydot = -x
}

fn main() {}
