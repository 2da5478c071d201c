//! Mistakes in keywords.

use kahan_core::prelude::*;

// The keyword must be `integral`, not `invariant`. The claim G, which uses H, gives no error.
kahan! {
    pub struct Invariant;
    xdot = y;
    ydot = -x;
    invariant H = x^2 + y^2;
    integral G = 2*H;
}

// The keyword must be `bracket`, not `poisson`.
kahan! {
    pub struct Poisson;
    xdot = y;
    ydot = -x;
    poisson P { {x,y} = 1; }
    integral H = x^2 + y^2;
}

// The keyword is misspelt.
kahan! {
    pub struct Slip;
    xdot = y;
    ydot = -x;
    integrl H = x^2 + y^2;
}

fn main() {}
