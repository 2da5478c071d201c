//! Mistakes in claims.

use kahan_core::prelude::*;

// A bracket is no function, so a formula cannot use it.
kahan! {
    pub struct BracketAsAFunction;
    xdot = y;
    ydot = -x;
    bracket P { {x,y} = 1; }
    integral H = P*(x^2 + y^2);
}

// Claims must be rational functions.
kahan! {
    pub struct FunctionCall;
    xdot = y;
    ydot = -x;
    integral H = sqrt(x^2 + y^2);
}

// A claim cannot have the name of a parameter.
kahan! {
    pub struct NamedLikeAParameter { w }
    xdot = w*y;
    ydot = -w*x;
    integral w = x^2 + y^2;
}

// Every name may have only one meaning.
kahan! {
    pub struct NamedLikeAState;
    xdot = y;
    ydot = -x;
    integral x = x^2 + y^2;
}

// The name `eps` is reserved for half the time step.
kahan! {
    pub struct NamedLikeTheHalfStep;
    xdot = y;
    ydot = -x;
    integral eps = x^2 + y^2;
}

// Two claims have the same name.
kahan! {
    pub struct NamedTwice;
    xdot = y;
    ydot = -x;
    integral H = x^2 + y^2;
    integral H = 2*x^2 + 2*y^2;
}

// The quotient of two densities is an integral, so the second density is refused.
kahan! {
    pub struct TwoDensities;
    xdot = y;
    ydot = -x;
    density rho = 1;
    density sigma = x^2 + y^2;
}

// A claim may use states, parameters, `eps` and earlier claims.
kahan! {
    pub struct UnknownName;
    xdot = y;
    ydot = -x;
    integral H = x^2 + y^2 + z^2;
}

// A claim may use earlier claims only.
kahan! {
    pub struct UsedTooEarly;
    xdot = y;
    ydot = -x;
    integral K = H^2;
    integral H = x^2 + y^2;
}

// A claim needs a name.
kahan! {
    pub struct WithoutAName;
    xdot = y;
    ydot = -x;
    integral = x^2 + y^2;
}

// A claim needs a value.
kahan! {
    pub struct WithoutAValue;
    xdot = y;
    ydot = -x;
    integral H = ;
}

// The divisor is the literal 0.
kahan! {
    pub struct ZeroDivisor;
    xdot = y;
    ydot = -x;
    integral H = (x^2 + y^2)/0;
}

fn main() {}
