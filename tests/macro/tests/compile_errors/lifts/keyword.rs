//! The keyword `lift` stands in wrong places.

use kahan_core::prelude::*;

// The keyword must follow the visibility.
kahan! {
    pub lift struct Behind;
    xdot = v;
    vdot = -sin(x);
}

// The keyword cannot stand in the middle of a block.
kahan! {
    pub struct Middle;
    xdot = v;
    lift;
    vdot = -x;
}

// The keyword may stand only once.
kahan! {
    lift pub struct Twice;
    lift;
    xdot = sin(x);
}

// Families cannot be lifted.
kahan! {
    lift pub struct Chain;
    for i in periodic { x[i]dot = sin(x[i+1] - x[i]); }
}

fn main() {}
