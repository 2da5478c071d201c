//! A search that ends at the macro's limit names the command that goes on.

use kahan_core::prelude::*;

kahan! {
    lift pub struct Limit { k, n }
    xdot = -x^n/(k + x^n) + cbrt(x)*x^(5/7);
}

kahan! {
    lift struct Other;
    xdot = log(1 + x^2) - tanh(x - a);
    adot = asin(x/9) + atanh(a/9);
}

fn main() {}
