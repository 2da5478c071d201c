//! Keywords.

use kahan_core::prelude::*;

// Another word for an integral; what uses it is no second mistake.
kahan! {
    pub struct Invariant;
    xdot = y;
    ydot = -x;
    invariant H = x^2 + y^2;
    integral G = 2*H;
}

// Another word for a bracket.
kahan! {
    pub struct Poisson;
    xdot = y;
    ydot = -x;
    poisson P { {x,y} = 1; }
    integral H = x^2 + y^2;
}

// A slip.
kahan! {
    pub struct Slip;
    xdot = y;
    ydot = -x;
    integrl H = x^2 + y^2;
}

fn main() {}
