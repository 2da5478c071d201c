//! The misprint: the paper has `z` for `z^2`.

use kahan_core::prelude::*;

kahan! {
    pub struct E3;
    xdot = x*z;
    ydot = y*z;
    zdot = -x^2 - y^2;
    bracket Q {
        {y,z} = x*(1 - eps^2*z)/(1 + eps^2*(x^2 + y^2));
        {z,x} = y*(1 - eps^2*z)/(1 + eps^2*(x^2 + y^2));
    }
}

fn main() {}
