//! Drifts.

use kahan_core::prelude::*;

// A density is no function of F.
kahan! {
    pub struct ByADensity;
    xdot = y;
    ydot = -x;
    density rho = 1;
    drift F = x^2 + y^2 by rho*F;
}

// A state is no function of F.
kahan! {
    pub struct ByAState;
    xdot = x^2;
    drift F = 1/x by F - 2*eps*x;
}

// An unknown name.
kahan! {
    pub struct ByAnUnknownName;
    xdot = x^2;
    drift F = 1/x by F - 2*epsilon;
}

// A division by the number 0.
kahan! {
    pub struct ByADivisorThatIsZero;
    xdot = x^2;
    drift F = 1/x by (F - 2*eps)/0;
}

// A divisor that expands to 0.
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

// A function of no state.
kahan! {
    pub struct Constant;
    xdot = x^2;
    drift F = eps by F;
}

// The name of a drift stands for its function only behind `by`.
kahan! {
    pub struct InItsOwnFunction;
    xdot = x^2;
    drift F = 1/F by F - 2*eps;
}

// A state and a drift of one name.
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

// `by` belongs to drifts.
kahan! {
    pub struct IntegralWithBy;
    xdot = x^2;
    integral F = 1/x by F - 2*eps;
}

// The next value of F is missing.
kahan! {
    pub struct WithoutBy;
    xdot = x^2;
    drift F = 1/x;
}

// The name of the claim is missing.
kahan! {
    pub struct WithoutAName;
    xdot = x^2;
    drift = 1/x by 1/x - 2*eps;
}

fn main() {}
