//! Names.

use kahan_core::prelude::*;

// A claim is about a field.
kahan! {
    pub struct ClaimWithoutAField;
    integral H = 1;
}

// A name means one thing.
kahan! {
    pub struct ConstantLikeAState;
    const x = 2;
    xdot = x;
}

// Constants are known while compiling.
kahan! {
    pub struct ConstantThatVaries { k }
    const c = 2*k;
    xdot = c*k*x;
}

// A name means one thing.
kahan! {
    pub struct ConstantTwice;
    const c = 2;
    const c = 3;
    xdot = c*x;
}

// One equation a state.
kahan! {
    pub struct DuplicateEquation;
    xdot = y;
    ydot = -x;
    xdot = -y;
}

// The lunate epsilon is another letter.
kahan! {
    pub struct GreekHalfStep;
    xdot = y;
    ydot = -x;
    integral H = (x^2 + y^2)*(1 + ϵ^2);
}

// `eps` is the half time step in every claim.
kahan! {
    pub struct HalfStepAsAState;
    epsdot = -eps;
}

// Coefficients have even powers of the half step, and a value where it is 0.
kahan! {
    pub struct OddPowersOfTheHalfStep;
    xdot = y - eps^2*x;
    ydot = eps^2*y - x*(1 + eps^3*y);
}

kahan! {
    pub struct DivisionByTheHalfStep;
    xdot = x/eps^2;
}

// Keywords are no parameters.
kahan! {
    pub struct Keyword { k }
    xdot = k*y;
    ydot = -k*super;
}

// The left-hand side is the derivative.
kahan! {
    pub struct MissingDot;
    x = y;
    ydot = -x;
}

// One slip in a left-hand side, one error: the uses of `x` are right.
kahan! {
    pub struct MisspeltDot;
    xdto = y;
    ydot = -x;
}

// Every state has an equation.
kahan! {
    pub struct NoEquation;
    xdot = x*(1 - z);
}

// A field has at least one equation.
kahan! {
    pub struct NothingInTheBlock;
}

// `dot` of what?
kahan! {
    pub struct OnlyDot;
    dot = 1;
}

// The nearest name is suggested.
kahan! {
    pub struct Slip { omega }
    xdot = y;
    ydot = -omgea*x;
}

// Names differ by their case.
kahan! {
    pub struct WrongCase { Omega }
    xdot = y;
    ydot = -omega*x;
}

fn main() {}
