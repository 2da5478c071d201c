//! A field has at least one equation.

use kahan_core::prelude::*;

kahan! {
    pub struct Nothing;
}

fn main() {}
