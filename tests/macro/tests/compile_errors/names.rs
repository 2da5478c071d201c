//! Names.

use kahan_core::prelude::*;

// A claim needs a field.
kahan! {
    pub struct ClaimWithoutAField;
    integral H = 1;
}

// A name has one meaning.
kahan! {
    pub struct ConstantLikeAState;
    const x = 2;
    xdot = x;
}

// Constants must be known at compile time.
kahan! {
    pub struct ConstantThatVaries { k }
    const c = 2*k;
    xdot = c*k*x;
}

// A name has one meaning.
kahan! {
    pub struct ConstantTwice;
    const c = 2;
    const c = 3;
    xdot = c*x;
}

// Every state has one equation.
kahan! {
    pub struct DuplicateEquation;
    xdot = y;
    ydot = -x;
    xdot = -y;
}

// The lunate epsilon is a different letter.
kahan! {
    pub struct GreekHalfStep;
    xdot = y;
    ydot = -x;
    integral H = (x^2 + y^2)*(1 + ϵ^2);
}

// `eps` denotes the half time step in every claim.
kahan! {
    pub struct HalfStepAsAState;
    epsdot = -eps;
}

// Coefficients are even in the half step and finite at 0.
kahan! {
    pub struct OddPowersOfTheHalfStep;
    xdot = y - eps^2*x;
    ydot = eps^2*y - x*(1 + eps^3*y);
}

kahan! {
    pub struct DivisionByTheHalfStep;
    xdot = x/eps^2;
}

// Keywords cannot be parameters.
kahan! {
    pub struct Keyword { k }
    xdot = k*y;
    ydot = -k*super;
}

// The left-hand side must be a derivative.
kahan! {
    pub struct MissingDot;
    x = y;
    ydot = -x;
}

// A misspelt left-hand side gives one error; the uses of `x` are right.
kahan! {
    pub struct MisspeltDot;
    xdto = y;
    ydot = -x;
}

// Every state needs an equation.
kahan! {
    pub struct NoEquation;
    xdot = x*(1 - z);
}

// A field needs an equation.
kahan! {
    pub struct NothingInTheBlock;
}

// `dot` without a state.
kahan! {
    pub struct OnlyDot;
    dot = 1;
}

// A similar name is suggested.
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
