//! A density that is claimed under a condition is not available as the method `density`.

use kahan_core::prelude::*;

kahan! {
    pub struct Spring { k }
    xdot = v;
    vdot = -k*x;
    density rho = 1 when k = 1;
}

fn main() {
    let spring = Spring { k: 1.0 };
    let weight = 2.0 * spring.density(&vector![1.0, 0.0], 0.1);
}
