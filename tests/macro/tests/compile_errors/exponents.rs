//! Mistakes in exponents.

use kahan_core::prelude::*;

// Exponents in claims are at most 64, so that the proof stays quick.
kahan! {
    pub struct ClaimTooHigh;
    xdot = y;
    ydot = -x;
    integral H = (x^2 + y^2)^65;
}

// A root is no polynomial.
kahan! {
    pub struct Fractional;
    xdot = x^1.5;
}

// An exponent must be written without parentheses.
kahan! {
    pub struct InParentheses;
    xdot = x^(1+1);
}

// A number must follow `^`.
kahan! {
    pub struct Missing;
    xdot = x^;
}

// An equation needs a quotient instead of a negative exponent.
kahan! {
    pub struct Negative { k }
    xdot = -k^-1*x;
}

// Exponents of parameters are at most 64, because their powers are expanded.
kahan! {
    pub struct ParameterTooHigh { k }
    xdot = -k^65*x;
}

// The degree must be known at compile time, so exponents are numbers.
kahan! {
    pub struct Symbolic { n }
    xdot = x^n;
}

// The meaning of `a^b^c` is ambiguous.
kahan! {
    pub struct Tower { a }
    xdot = a^2^3*x;
}

fn main() {}
