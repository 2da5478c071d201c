//! Calculators disagree about `a^b^c`.

use kahan_core::prelude::*;

kahan! {
    pub struct Tower { a }
    xdot = a^2^3*x;
}

fn main() {}
