//! A block outside of functions lacks a header. Only rustc knows where a block is, and reports it.

use kahan_core::prelude::*;

kahan! {
    xdot = y;
    ydot = -x;
}

fn main() {}
