//! Mistakes in drifts.

use kahan_core::prelude::*;

// The next value of F must be a formula in F, without densities.
kahan! {
    pub struct ByADensity;
    xdot = y;
    ydot = -x;
    density rho = 1;
    drift F = x^2 + y^2 by rho*F;
}

// The next value of F must be a formula in F, without states.
kahan! {
    pub struct ByAState;
    xdot = x^2;
    drift F = 1/x by F - 2*eps*x;
}

// A name is unknown.
kahan! {
    pub struct ByAnUnknownName;
    xdot = x^2;
    drift F = 1/x by F - 2*epsilon;
}

// The formula divides by the number 0.
kahan! {
    pub struct ByADivisorThatIsZero;
    xdot = x^2;
    drift F = 1/x by (F - 2*eps)/0;
}

// The divisor expands to 0.
kahan! {
    pub struct ByADivisorThatVanishes;
    xdot = x^2;
    drift F = 1/x by 1/((F + 1)^2 - F^2 - 2*F - 1);
}

// The claim is false, because the next value of F = 1/x is F - 2*eps.
kahan! {
    pub struct ByTheWrongSign;
    xdot = x^2;
    drift F = 1/x by F + 2*eps;
}

// The function contains no state.
kahan! {
    pub struct Constant;
    xdot = x^2;
    drift F = eps by F;
}

// The name of a drift denotes its function only after `by`.
kahan! {
    pub struct InItsOwnFunction;
    xdot = x^2;
    drift F = 1/F by F - 2*eps;
}

// A state and a drift have the same name.
kahan! {
    pub struct NamedLikeAState;
    xdot = x^2;
    drift x = 1/x by x - 2*eps;
}

// The next value after `by` is missing.
kahan! {
    pub struct NothingBehindBy;
    xdot = x^2;
    drift F = 1/x by;
}

// Only drifts may contain `by`.
kahan! {
    pub struct IntegralWithBy;
    xdot = x^2;
    integral F = 1/x by F - 2*eps;
}

// The word `by` and the next value of F are missing.
kahan! {
    pub struct WithoutBy;
    xdot = x^2;
    drift F = 1/x;
}

// The name of the drift is missing.
kahan! {
    pub struct WithoutAName;
    xdot = x^2;
    drift = 1/x by 1/x - 2*eps;
}

fn main() {}
