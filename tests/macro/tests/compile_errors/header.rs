//! Mistakes in headers.

use kahan_core::prelude::*;

// A header must not have type parameters. The macro itself adds one for the scalar type.
kahan! {
    pub struct Generic<T> { k }
    xdot = -k*x;
}

// Parameters are separated by `,`.
kahan! {
    pub struct MissingComma { k l }
    xdot = -k*x - l;
}

// A header must end with `;` or with its parameters.
kahan! {
    pub struct MissingSemicolon
    xdot = -x;
}

// A parameter becomes a field of a struct, so its name cannot be a keyword of Rust.
kahan! {
    pub struct ParameterIsAKeyword { type }
    xdot = -type*x;
}

// A name is either a state or a parameter.
kahan! {
    pub struct ParameterIsAState { k, x }
    xdot = -k*x;
}

// The name `eps` is reserved for half the time step.
kahan! {
    pub struct ParameterIsReserved { eps }
    xdot = -eps*x;
}

// Two parameters have the same name.
kahan! {
    pub struct ParameterTwice { k, k }
    xdot = -k*x;
}

// Values are given where the system is constructed.
kahan! {
    pub struct ParameterWithAValue { k = 2 }
    xdot = -k*x;
}

// A parameter must not have a visibility. All parameters are public.
kahan! {
    pub struct PublicParameter { pub k }
    xdot = -k*x;
}

// Parameters need names.
kahan! {
    pub struct Tuple(k);
    xdot = -k*x;
}

// The macro gives every parameter the scalar's type.
kahan! {
    pub struct TypedParameter { k: f64 }
    xdot = -k*x;
}

// An unused parameter is an error.
kahan! {
    pub struct UnusedParameter { k, l }
    xdot = -k*x;
}

fn main() {}
