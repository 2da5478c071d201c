//! Parameters are public.

use kahan_core::prelude::*;

kahan! {
    pub struct Decay { pub k }
    xdot = -k*x;
}

fn main() {}
