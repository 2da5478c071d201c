//! The parameter is an integer instead of a float, with and without a suffix.

use kahan_core::prelude::*;

kahan! {
    pub struct Spring { k }
    xdot = v;
    vdot = -k*x;
}

fn main() {
    let spring = Spring { k: 1_i64 };
    spring.orbit(vector![1, 0], 1).count();
}
