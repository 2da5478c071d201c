//! Mistakes in names.

use kahan_core::prelude::*;

// The block has a claim, but no equations.
kahan! {
    pub struct ClaimWithoutAField;
    integral H = 1;
}

// Every name may have only one meaning.
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

// Two constants have the same name.
kahan! {
    pub struct ConstantTwice;
    const c = 2;
    const c = 3;
    xdot = c*x;
}

// Every state must have exactly one equation.
kahan! {
    pub struct DuplicateEquation;
    xdot = y;
    ydot = -x;
    xdot = -y;
}

// Half the time step is called `eps`. The letter ϵ (lunate epsilon) is an unknown name.
kahan! {
    pub struct GreekHalfStep;
    xdot = y;
    ydot = -x;
    integral H = (x^2 + y^2)*(1 + ϵ^2);
}

// The name `eps` is reserved for half the time step.
kahan! {
    pub struct HalfStepAsAState;
    epsdot = -eps;
}

// The coefficients of a field must be even functions of `eps`, and finite at `eps = 0`.
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

// The misspelt left-hand side gives one error; the uses of `x` are right.
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

// A state is missing before `dot`.
kahan! {
    pub struct OnlyDot;
    dot = 1;
}

// The message must suggest a similar name.
kahan! {
    pub struct Slip { omega }
    xdot = y;
    ydot = -omgea*x;
}

// The two names differ by their case.
kahan! {
    pub struct WrongCase { Omega }
    xdot = y;
    ydot = -omega*x;
}

fn main() {}
