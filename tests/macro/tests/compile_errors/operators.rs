//! Mistakes in operators.

use kahan_core::prelude::*;

// Only round brackets may group expressions.
kahan! {
    pub struct BracketsForParentheses;
    xdot = [x - 1]*x;
}

// The operator `==` is a comparison.
kahan! {
    pub struct DoubleEquals;
    xdot == x;
}

// The operator `**` is the notation of Python for powers.
kahan! {
    pub struct DoubleStar;
    xdot = x**2;
}

// The right-hand side is empty. A constant state needs `xdot = 0;`.
kahan! {
    pub struct EmptyRightHandSide;
    xdot = ;
}

// Only `-` may precede an operand.
kahan! {
    pub struct LeadingPlus;
    xdot = + x;
}

// The right-hand side is missing.
kahan! {
    pub struct MissingEquals;
    xdot x;
}

// The final item must end with `;`, too.
kahan! {
    pub struct MissingLastSemicolon;
    xdot = y;
    ydot = -x
}

// Two operators stand in a row.
kahan! {
    pub struct MissingMiddleOperand;
    xdot = x + * 2;
}

// An operand is missing.
kahan! {
    pub struct MissingRightOperand;
    xdot = x*;
}

// Every item must end with `;`; the next equation is still read.
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

// The product `3 x` is two tokens without `*`.
kahan! {
    pub struct NumberBeforeName;
    xdot = 1 + 3 x;
}

// The text `2x` is one token. The product is written `2*x`.
kahan! {
    pub struct NumberBesideName;
    xdot = 1 + 2x;
}

// A product needs `*`, even between parentheses.
kahan! {
    pub struct ParenthesisBeforeParenthesis;
    xdot = (x - 1)(x + 1);
}

// The method `powi` is the notation of Rust for powers.
kahan! {
    pub struct Powi;
    xdot = x.powi(2) - x;
}

// The method `powi` is called on a sum.
kahan! {
    pub struct PowiOfParentheses;
    xdot = (x - 1).powi(2);
}

// `%` is no operation on polynomials.
kahan! {
    pub struct Remainder;
    xdot = x%2;
}

// The equation contains two `=`.
kahan! {
    pub struct SecondEquals;
    xdot = y = 0;
    ydot = -x;
}

// The second `;` ends no item.
kahan! {
    pub struct StraySemicolon;
    xdot = x;;
}

fn main() {}
