//! A function of the states is another field.

use kahan_core::prelude::*;

kahan! {
    pub struct Pendulum;
    xdot = y;
    ydot = -sin(x);
}

fn main() {}
