//! A claim is about a field.

use kahan_core::prelude::*;

kahan! {
    pub struct Nothing;
    integral H = 1;
}

fn main() {}
