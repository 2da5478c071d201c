//! The macro's search for a lift reaches its limit. The error names a command to use instead.

use kahan_core::prelude::*;

kahan! {
    lift pub struct Limit { k, n }
    xdot = -x^n/(k + x^n) + cbrt(x)*x^(5/7);
}

fn main() {}
