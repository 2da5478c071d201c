//! Where `lift` stands.

use kahan_core::prelude::*;

// Behind the visibility.
kahan! {
    pub lift struct Behind;
    xdot = v;
    vdot = -sin(x);
}

// Not in the middle of a block.
kahan! {
    pub struct Middle;
    xdot = v;
    lift;
    vdot = -x;
}

// Not twice.
kahan! {
    lift pub struct Twice;
    lift;
    xdot = sin(x);
}

// Families are not lifted.
kahan! {
    lift pub struct Chain;
    for i in periodic { x[i]dot = sin(x[i+1] - x[i]); }
}

fn main() {}
