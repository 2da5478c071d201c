//! Big rationals need a feature that is not enabled.

use kahan_core::prelude::*;

kahan! {
    pub struct Spring { k }
    xdot = v;
    vdot = -k*x;
}

fn main() {
    let half = BigRational::new(1.into(), 2.into());
}
