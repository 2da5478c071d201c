//! `^` wants a number.

use kahan_core::prelude::*;

kahan! {
    pub struct Power;
    xdot = x^;
}

fn main() {}
