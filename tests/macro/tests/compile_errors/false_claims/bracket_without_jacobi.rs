//! Invariant under a linear rotation, and no Poisson bracket.

use kahan_core::prelude::*;

kahan! {
    pub struct Rest;
    xdot = 0;
    ydot = 0;
    zdot = 0;
    bracket P { {x,y} = y; {y,z} = y; {z,x} = x; }
}

fn main() {}
