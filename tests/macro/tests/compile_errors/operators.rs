//! Operators.

use kahan_core::prelude::*;

// Only round brackets group expressions.
kahan! {
    pub struct BracketsForParentheses;
    xdot = [x - 1]*x;
}

// `==` is a comparison.
kahan! {
    pub struct DoubleEquals;
    xdot == x;
}

// Python's operator for powers.
kahan! {
    pub struct DoubleStar;
    xdot = x**2;
}

// A constant state is written `xdot = 0;`.
kahan! {
    pub struct EmptyRightHandSide;
    xdot = ;
}

// Only `-` may precede an operand.
kahan! {
    pub struct LeadingPlus;
    xdot = + x;
}

// A left-hand side without a right-hand side.
kahan! {
    pub struct MissingEquals;
    xdot x;
}

// The last item ends with `;`, too.
kahan! {
    pub struct MissingLastSemicolon;
    xdot = y;
    ydot = -x
}

// Two operators in a row.
kahan! {
    pub struct MissingMiddleOperand;
    xdot = x + * 2;
}

// A missing operand.
kahan! {
    pub struct MissingRightOperand;
    xdot = x*;
}

// Every item ends with `;`; the next equation is still read.
kahan! {
    pub struct MissingSemicolon;
    xdot = y
    ydot = -x;
}

// A product needs `*`, even between names.
kahan! {
    pub struct NameBeforeName { k }
    xdot = k x;
}

// `x (y + 1)` would be a call in Rust.
kahan! {
    pub struct NameBeforeParenthesis { k }
    xdot = k (x + 1);
}

// `3 x`, two tokens.
kahan! {
    pub struct NumberBeforeName;
    xdot = 1 + 3 x;
}

// `2x`, one token.
kahan! {
    pub struct NumberBesideName;
    xdot = 1 + 2x;
}

// A product needs `*`, even between parentheses.
kahan! {
    pub struct ParenthesisBeforeParenthesis;
    xdot = (x - 1)(x + 1);
}

// Rust's method for powers.
kahan! {
    pub struct Powi;
    xdot = x.powi(2) - x;
}

// Rust's method for powers of a sum.
kahan! {
    pub struct PowiOfParentheses;
    xdot = (x - 1).powi(2);
}

// `%` is no operation on polynomials.
kahan! {
    pub struct Remainder;
    xdot = x%2;
}

// One equation with two `=`.
kahan! {
    pub struct SecondEquals;
    xdot = y = 0;
    ydot = -x;
}

// A `;` without an item.
kahan! {
    pub struct StraySemicolon;
    xdot = x;;
}

fn main() {}
