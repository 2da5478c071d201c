//! False claims.

use kahan_core::prelude::*;

// False, but zero modulo 2^61 - 1.
kahan! {
    pub struct APrimeTimesAState;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = 2305843009213693951*x;
}

// A Poisson bracket that is not invariant.
kahan! {
    pub struct BracketNotCarried;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    bracket P { {x,y} = 1; }
}

// Invariant under a linear rotation, but no Poisson bracket.
kahan! {
    pub struct BracketWithoutJacobi;
    xdot = 0;
    ydot = 0;
    zdot = 0;
    bracket P { {x,y} = y; {y,z} = y; {z,x} = x; }
}

// A trivial claim.
kahan! {
    pub struct Constant;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = 3;
}

// Equal to 1 after cancellation.
kahan! {
    pub struct ConstantInDisguise;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = (x + y)^2/(x^2 + 2*x*y + y^2);
}

// Lebesgue measure is invariant under the flow, but not under the map.
kahan! {
    pub struct DensityOfTheFlow;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
    density rho = 1;
}

// A claim without a value at any point, as its evaluation shows.
kahan! {
    pub struct DivisionByZeroAfterExpansion;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = x/((x + y)^2 - x^2 - 2*x*y - y^2);
}

// A claim without a value at any point.
kahan! {
    pub struct DivisionByZeroIdentically;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = x/(y - y);
}

// True for xi = 1 only.
kahan! {
    pub struct GenericParameters { xi }
    xdot = -x^2;
    ydot = -xi*x*y;
    zdot = 2*xi*y^2 + x*z;
    integral H = y/x;
}

// False, but an integral modulo 2^61 - 1.
kahan! {
    pub struct IntegralAndAMultipleOfAPrime;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = y/x + 2305843009213693951*z;
}

// An integral of the flow, but not of the map.
kahan! {
    pub struct IntegralOfTheFlow;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
    integral H = x*z + y^2;
}

// A degree that needs more points than usual.
kahan! {
    pub struct OfHighDegree;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = y/x*z^60;
}

// A misprint of the paper: `z` instead of `z^2`.
kahan! {
    pub struct Table4Row3AsPrinted;
    xdot = x*z;
    ydot = y*z;
    zdot = -x^2 - y^2;
    bracket Q {
        {y,z} = x*(1 - eps^2*z)/(1 + eps^2*(x^2 + y^2));
        {z,x} = y*(1 - eps^2*z)/(1 + eps^2*(x^2 + y^2));
    }
}

// A trivial claim.
kahan! {
    pub struct TheHalfStep;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = eps;
}

// The whole step h = 2 eps instead of eps.
kahan! {
    pub struct TheWholeStepForTheHalf;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral K = (x*z + y^2)/(1 - 4*eps^2*x^2);
}

// True for xi = 1, claimed for xi = -1.
kahan! {
    pub struct WhenAParameterIsSpecial { xi }
    xdot = -x^2;
    ydot = -xi*x*y;
    zdot = 2*xi*y^2 + x*z;
    integral H = y/x when xi = -1;
}

// True for eps = 1, claimed for eps = 2.
kahan! {
    pub struct WhenTheConditionDoesNotHelp;
    xdot = x*(1 - y);
    ydot = y*(x - 1);
    integral H = x + y when eps = 2;
}

// No Poisson bracket.
kahan! {
    pub struct ZeroBracket;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    bracket P { {x,y} = 0*x; {y,z} = z - z; }
}

// No invariant measure.
kahan! {
    pub struct ZeroDensity;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    density rho = x - x;
}

fn main() {}
