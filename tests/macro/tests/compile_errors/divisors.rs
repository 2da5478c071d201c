//! Mistakes in divisors.

use kahan_core::prelude::*;

// A quotient of states is no polynomial.
kahan! {
    pub struct State;
    xdot = y/x;
    ydot = 1;
}

// The divisor after `/` is the whole sum, which contains a state.
kahan! {
    pub struct SumWithAState { k }
    xdot = -x/(k + x);
}

// The divisor is the literal 0.
kahan! {
    pub struct Zero;
    xdot = -x/0;
}

// A constant makes the divisor 0.
kahan! {
    pub struct ZeroConstant;
    const c = 1/2 - 0.5;
    xdot = -x/c;
}

// The divisor expands to 0.
kahan! {
    pub struct ZeroInLetters { k }
    xdot = -x/(k*(k + 1) - k^2 - k);
}

fn main() {}
