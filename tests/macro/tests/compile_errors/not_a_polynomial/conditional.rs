//! A field has one formula everywhere.

use kahan_core::prelude::*;

kahan! {
    pub struct Switch;
    xdot = if x { 1 } else { 0 };
}

fn main() {}
