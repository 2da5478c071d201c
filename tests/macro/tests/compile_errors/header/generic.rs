//! The macro adds the type parameter.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay<T> { k }
    xdot = -k*x;
}

fn main() {}
