//! The method `integrals` needs a system that declares an integral.

use kahan_core::prelude::*;

kahan! {
    pub struct Spring { k }
    xdot = v;
    vdot = -k*x;
}

fn main() {
    let spring = Spring { k: 1.0 };
    let [energy] = spring.integrals(&vector![1.0, 0.0], 0.1).into();
}
