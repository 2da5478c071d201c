//! Drifts.

use kahan_core::prelude::*;

// A density depends on the states.
kahan! {
    pub struct ByADensity;
    xdot = y;
    ydot = -x;
    density rho = 1;
    drift F = x^2 + y^2 by rho*F;
}

// A state is more than F.
kahan! {
    pub struct ByAState;
    xdot = x^2;
    drift F = 1/x by F - 2*eps*x;
}

// A name that nobody knows.
kahan! {
    pub struct ByAnUnknownName;
    xdot = x^2;
    drift F = 1/x by F - 2*epsilon;
}

// Zero, in figures.
kahan! {
    pub struct ByADivisorThatIsZero;
    xdot = x^2;
    drift F = 1/x by (F - 2*eps)/0;
}

// Without a value at any point.
kahan! {
    pub struct ByADivisorThatVanishes;
    xdot = x^2;
    drift F = 1/x by 1/((F + 1)^2 - F^2 - 2*F - 1);
}

// The sign is that of F = -1/x.
kahan! {
    pub struct ByTheWrongSign;
    xdot = x^2;
    drift F = 1/x by F + 2*eps;
}

// True, and says nothing.
kahan! {
    pub struct Constant;
    xdot = x^2;
    drift F = eps by F;
}

// A drift stands for its function behind `by` alone.
kahan! {
    pub struct InItsOwnFunction;
    xdot = x^2;
    drift F = 1/F by F - 2*eps;
}

// A name means one thing.
kahan! {
    pub struct NamedLikeAState;
    xdot = x^2;
    drift x = 1/x by x - 2*eps;
}

// Nothing behind `by`.
kahan! {
    pub struct NothingBehindBy;
    xdot = x^2;
    drift F = 1/x by;
}

// `by` stands in a drift.
kahan! {
    pub struct IntegralWithBy;
    xdot = x^2;
    integral F = 1/x by F - 2*eps;
}

// How F goes on is missing.
kahan! {
    pub struct WithoutBy;
    xdot = x^2;
    drift F = 1/x;
}

// A claim is called by its name.
kahan! {
    pub struct WithoutAName;
    xdot = x^2;
    drift = 1/x by 1/x - 2*eps;
}

fn main() {}
