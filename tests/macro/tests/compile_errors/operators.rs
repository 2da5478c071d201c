//! Operators.

use kahan_core::prelude::*;

// Only round brackets group.
kahan! {
    pub struct BracketsForParentheses;
    xdot = [x - 1]*x;
}

// `==` compares.
kahan! {
    pub struct DoubleEquals;
    xdot == x;
}

// Python's power.
kahan! {
    pub struct DoubleStar;
    xdot = x**2;
}

// A state at rest is written `xdot = 0;`.
kahan! {
    pub struct EmptyRightHandSide;
    xdot = ;
}

// Only `-` stands before an operand.
kahan! {
    pub struct LeadingPlus;
    xdot = + x;
}

// A left-hand side, and then?
kahan! {
    pub struct MissingEquals;
    xdot x;
}

// The last item ends with `;` as well.
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

// Something is to be multiplied with what?
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

// A product needs its `*`, also between names.
kahan! {
    pub struct NameBeforeName { k }
    xdot = k x;
}

// `x (y + 1)` would be a call in Rust.
kahan! {
    pub struct NameBeforeParenthesis { k }
    xdot = k (x + 1);
}

// `3 x`, as two tokens.
kahan! {
    pub struct NumberBeforeName;
    xdot = 1 + 3 x;
}

// `2x`, as one token.
kahan! {
    pub struct NumberBesideName;
    xdot = 1 + 2x;
}

// A product needs its `*`, also between parentheses.
kahan! {
    pub struct ParenthesisBeforeParenthesis;
    xdot = (x - 1)(x + 1);
}

// Rust's power.
kahan! {
    pub struct Powi;
    xdot = x.powi(2) - x;
}

// Rust's power, of a sum.
kahan! {
    pub struct PowiOfParentheses;
    xdot = (x - 1).powi(2);
}

// `%` is no operation on polynomials.
kahan! {
    pub struct Remainder;
    xdot = x%2;
}

// One equation, two `=`.
kahan! {
    pub struct SecondEquals;
    xdot = y = 0;
    ydot = -x;
}

// A `;` that ends nothing.
kahan! {
    pub struct StraySemicolon;
    xdot = x;;
}

fn main() {}
