//! Claims.

use kahan_core::prelude::*;

// A bracket has no value.
kahan! {
    pub struct BracketAsAFunction;
    xdot = y;
    ydot = -x;
    bracket P { {x,y} = 1; }
    integral H = P*(x^2 + y^2);
}

// Claims are rational.
kahan! {
    pub struct FunctionCall;
    xdot = y;
    ydot = -x;
    integral H = sqrt(x^2 + y^2);
}

// A name means one thing.
kahan! {
    pub struct NamedLikeAParameter { w }
    xdot = w*y;
    ydot = -w*x;
    integral w = x^2 + y^2;
}

// A name means one thing.
kahan! {
    pub struct NamedLikeAState;
    xdot = y;
    ydot = -x;
    integral x = x^2 + y^2;
}

// `eps` is the half time step.
kahan! {
    pub struct NamedLikeTheHalfStep;
    xdot = y;
    ydot = -x;
    integral eps = x^2 + y^2;
}

// A name means one thing.
kahan! {
    pub struct NamedTwice;
    xdot = y;
    ydot = -x;
    integral H = x^2 + y^2;
    integral H = 2*x^2 + 2*y^2;
}

// The second density is an integral in disguise.
kahan! {
    pub struct TwoDensities;
    xdot = y;
    ydot = -x;
    density rho = 1;
    density sigma = x^2 + y^2;
}

// A claim speaks of states, parameters, `eps` and earlier claims.
kahan! {
    pub struct UnknownName;
    xdot = y;
    ydot = -x;
    integral H = x^2 + y^2 + z^2;
}

// Claims are read in order.
kahan! {
    pub struct UsedTooEarly;
    xdot = y;
    ydot = -x;
    integral K = H^2;
    integral H = x^2 + y^2;
}

// A claim is called by its name.
kahan! {
    pub struct WithoutAName;
    xdot = y;
    ydot = -x;
    integral = x^2 + y^2;
}

// A claim says something.
kahan! {
    pub struct WithoutAValue;
    xdot = y;
    ydot = -x;
    integral H = ;
}

// Zero, in figures.
kahan! {
    pub struct ZeroDivisor;
    xdot = y;
    ydot = -x;
    integral H = (x^2 + y^2)/0;
}

fn main() {}
