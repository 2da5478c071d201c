//! Mistakes in keywords.

use kahan_core::prelude::*;

// Another word stands for `integral`. The claim G, which uses H, gives no second error.
kahan! {
    pub struct Invariant;
    xdot = y;
    ydot = -x;
    invariant H = x^2 + y^2;
    integral G = 2*H;
}

// Another word stands for `bracket`.
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
