//! A search that reaches the macro's limit names the command that continues it.

use kahan_core::prelude::*;

kahan! {
    lift pub struct Limit { k, n }
    xdot = -x^n/(k + x^n) + cbrt(x)*x^(5/7);
}

fn main() {}
