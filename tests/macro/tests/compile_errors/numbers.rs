//! Mistakes in numbers.

use kahan_core::prelude::*;

// Decimal exponents have a limit, which bounds the memory of literals.
kahan! {
    pub struct Astronomical;
    xdot = -1e5000*x;
}

// Numbers must be decimal.
kahan! {
    pub struct Hexadecimal;
    xdot = -0x1F*x;
}

// `.5` is no number in Rust.
kahan! {
    pub struct LeadingPoint;
    xdot = -.5*x;
}

// Text is no number.
kahan! {
    pub struct String;
    xdot = -"2"*x;
}

// A suffix names a type, and numbers here have none.
kahan! {
    pub struct SuffixedLiteral;
    xdot = -2f64*x;
}

// `2.` is a number, but `2.x` reads as field access.
kahan! {
    pub struct TrailingPoint;
    xdot = 1 - 2.x;
}

fn main() {}
