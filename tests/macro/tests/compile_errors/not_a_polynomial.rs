//! Fields that are not polynomials.

use kahan_core::prelude::*;

// A field must be one formula, without cases.
kahan! {
    pub struct Conditional;
    xdot = if x { 1 } else { 0 };
}

// Parameters have plain names, without field access.
kahan! {
    pub struct FieldOfSelf { k }
    xdot = -self.k*x;
}

// An indexed parameter is no name.
kahan! {
    pub struct Index { k }
    xdot = -k[0]*x;
}

// The macro cannot read the result of another macro.
kahan! {
    pub struct MacroCall;
    xdot = -rate!()*x;
}

// Methods are not available in fields.
kahan! {
    pub struct Method;
    xdot = -x.abs();
}

// A path cannot stand for a name.
kahan! {
    pub struct Path;
    xdot = -physics::RATE*x;
}

// A function of the states is no polynomial.
kahan! {
    pub struct Sine;
    xdot = y;
    ydot = -sin(x);
}

// In Rust, `k(x + 1)` is a function call, not a product.
kahan! {
    pub struct UnknownFunction { k }
    xdot = k(x + 1);
}

fn main() {}
