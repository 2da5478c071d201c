//! The parameter is an integer instead of a float.

use kahan_core::prelude::*;

kahan! {
    pub struct Spring { k }
    xdot = v;
    vdot = -k*x;
}

fn main() {
    let spring = Spring { k: 1 };
    spring.step(&vector![1.0, 0.0], 0.1);
}
