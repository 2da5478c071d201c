//! Fields that are no polynomials.

use kahan_core::prelude::*;

// A field has one formula everywhere.
kahan! {
    pub struct Conditional;
    xdot = if x { 1 } else { 0 };
}

// Parameters are named, not reached for.
kahan! {
    pub struct FieldOfSelf { k }
    xdot = -self.k*x;
}

// An indexed parameter is no name.
kahan! {
    pub struct Index { k }
    xdot = -k[0]*x;
}

// The macro reads text, not the result of another macro.
kahan! {
    pub struct MacroCall;
    xdot = -rate!()*x;
}

// A method is no operation on polynomials.
kahan! {
    pub struct Method;
    xdot = -x.abs();
}

// A path is no name.
kahan! {
    pub struct Path;
    xdot = -physics::RATE*x;
}

// A function of the states is another field.
kahan! {
    pub struct Sine;
    xdot = y;
    ydot = -sin(x);
}

// A product in the mathematician's way, a call in Rust's.
kahan! {
    pub struct UnknownFunction { k }
    xdot = k(x + 1);
}

fn main() {}
