//! Mistakes in the conditions of claims.

use kahan_core::prelude::*;

// A condition must be an equation, not a comparison.
kahan! {
    pub struct Comparison { k }
    xdot = k*y;
    ydot = -k*x;
    integral H = x^2 + y^2 when k > 0;
}

// The conditions give one name two different values.
kahan! {
    pub struct Contradiction { k }
    xdot = k*y;
    ydot = -k*x;
    integral H = x^2 + y^2 when k = 1, k = 2;
}

// The claim is false under its condition, so the counterexample must satisfy k = 2*l.
kahan! {
    pub struct FalseOnTheRelation { k, l }
    xdot = k*y;
    ydot = -l*x;
    integral H = x^2 + y^2 when k = 2*l;
}

// The third relation follows from the first two, so it must be removed.
kahan! {
    pub struct Follows { k, l, m }
    xdot = k*y;
    ydot = -l*x;
    zdot = m;
    integral H = x^2 + y^2 when k = m, m = l, k*m = l*m;
}

// A relation after `when` must contain a name linearly, so that it can be solved for this name.
kahan! {
    pub struct NoLinearName { k, l }
    xdot = k*y;
    ydot = -l*x;
    integral H = x^2 + y^2 when k^2 = l^2 + 1;
}

// No relation follows `when`.
kahan! {
    pub struct NothingBehind { k }
    xdot = k*y;
    ydot = -k*x;
    integral H = x^2 + y^2 when;
}

// A condition cannot fix a state.
kahan! {
    pub struct OnAState;
    xdot = y;
    ydot = -x;
    integral H = x^2 + y^2 when x = 1;
}

// The name of a parameter is misspelt.
kahan! {
    pub struct OnNothing { omega }
    xdot = omega*y;
    ydot = -omega*x;
    integral H = x^2 + y^2 when omgea = 1;
}

// The condition sets a product to 0, but does not say which factor is 0.
kahan! {
    pub struct Product { k, l }
    xdot = k*y;
    ydot = -l*x;
    integral H = y when k*l = 0;
}

// The field divides by zero under this condition.
kahan! {
    pub struct SingularSpecialisation { k }
    xdot = y/k;
    ydot = -x/k;
    integral H = x^2 + y^2 when k = 0;
}

// For eps = 0 every function is conserved.
kahan! {
    pub struct StepZero;
    xdot = y;
    ydot = -x;
    integral H = x*y when eps = 0;
}

fn main() {}
