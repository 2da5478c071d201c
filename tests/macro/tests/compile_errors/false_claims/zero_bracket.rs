//! No bracket.

use kahan_core::prelude::*;

kahan! {
    pub struct E1;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    bracket P { {x,y} = 0*x; {y,z} = z - z; }
}

fn main() {}
