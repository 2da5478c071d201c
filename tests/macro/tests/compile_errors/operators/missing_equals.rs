//! A left-hand side, and then?

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    xdot x;
}

fn main() {}
