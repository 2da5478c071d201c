//! Divisors.

use kahan_core::prelude::*;

// A quotient of states is not polynomial.
kahan! {
    pub struct State;
    xdot = y/x;
    ydot = 1;
}

// The whole divisor counts.
kahan! {
    pub struct SumWithAState { k }
    xdot = -x/(k + x);
}

// Zero, in figures.
kahan! {
    pub struct Zero;
    xdot = -x/0;
}

// Zero, by a constant.
kahan! {
    pub struct ZeroConstant;
    const c = 1/2 - 0.5;
    xdot = -x/c;
}

// Zero, after expansion.
kahan! {
    pub struct ZeroInLetters { k }
    xdot = -x/(k*(k + 1) - k^2 - k);
}

fn main() {}
