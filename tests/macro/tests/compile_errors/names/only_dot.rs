//! `dot` of what?

use kahan_core::prelude::*;

kahan! {
    pub struct Growth;
    dot = 1;
}

fn main() {}
