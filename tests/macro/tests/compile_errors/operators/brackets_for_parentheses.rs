//! Only round brackets group.

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    xdot = [x - 1]*x;
}

fn main() {}
