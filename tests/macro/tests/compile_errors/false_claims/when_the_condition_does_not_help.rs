//! True at eps = 1, claimed at eps = 2.

use kahan_core::prelude::*;

kahan! {
    pub struct LotkaVolterra;
    xdot = x*(1 - y);
    ydot = y*(x - 1);
    integral H = x + y when eps = 2;
}

fn main() {}
