//! What hangs on a mistake is not reported as well.

use kahan_core::prelude::*;

kahan! {
    pub struct Chain { k }
    const c = 1/0;
    xdot = c*y + k;
    y = x;
    integral H = c*x + y;
    integral K = H^2;
}

fn main() {}
