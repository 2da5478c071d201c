//! Claims that are false.

use kahan_core::prelude::*;

// The claim is false, but its function is 0 modulo the prime 2^61 - 1.
kahan! {
    pub struct APrimeTimesAState;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = 2305843009213693951*x;
}

// The Poisson bracket is not invariant.
kahan! {
    pub struct BracketNotCarried;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    bracket P { {x,y} = 1; }
}

// The tensor is invariant under a linear rotation, but is no Poisson bracket.
kahan! {
    pub struct BracketWithoutJacobi;
    xdot = 0;
    ydot = 0;
    zdot = 0;
    bracket P { {x,y} = y; {y,z} = y; {z,x} = x; }
}

// The claimed integral is a constant.
kahan! {
    pub struct Constant;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = 3;
}

// The function equals 1 after cancellation.
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

// The divisor of the claim is 0 after its expansion.
kahan! {
    pub struct DivisionByZeroAfterExpansion;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = x/((x + y)^2 - x^2 - 2*x*y - y^2);
}

// The claim is undefined at every point, because it divides by y - y.
kahan! {
    pub struct DivisionByZeroIdentically;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = x/(y - y);
}

// The claim is true for xi = 1 only.
kahan! {
    pub struct GenericParameters { xi }
    xdot = -x^2;
    ydot = -xi*x*y;
    zdot = 2*xi*y^2 + x*z;
    integral H = y/x;
}

// The claim is false, but holds modulo 2^61 - 1.
kahan! {
    pub struct IntegralAndAMultipleOfAPrime;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = y/x + 2305843009213693951*z;
}

// The function is an integral of the flow, but not of the map.
kahan! {
    pub struct IntegralOfTheFlow;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);
    integral H = x*z + y^2;
}

// The degree of the claim is so high that its proof evaluates it at more points than usual.
kahan! {
    pub struct OfHighDegree;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = y/x*z^60;
}

// The paper of Hone and Petrera misprints this claim, with `z` instead of `z^2`.
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

// The claim is trivial, because its function does not depend on the point.
kahan! {
    pub struct TheHalfStep;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = eps;
}

// The claim contains the whole step h = 2 eps instead of eps.
kahan! {
    pub struct TheWholeStepForTheHalf;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral K = (x*z + y^2)/(1 - 4*eps^2*x^2);
}

// The claim is true for xi = 1, but is claimed for xi = -1.
kahan! {
    pub struct WhenAParameterIsSpecial { xi }
    xdot = -x^2;
    ydot = -xi*x*y;
    zdot = 2*xi*y^2 + x*z;
    integral H = y/x when xi = -1;
}

// The claim is true for eps = 1, but is claimed for eps = 2.
kahan! {
    pub struct WhenTheConditionDoesNotHelp;
    xdot = x*(1 - y);
    ydot = y*(x - 1);
    integral H = x + y when eps = 2;
}

// The tensor is no Poisson bracket.
kahan! {
    pub struct ZeroBracket;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    bracket P { {x,y} = 0*x; {y,z} = z - z; }
}

// The measure is not invariant.
kahan! {
    pub struct ZeroDensity;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    density rho = x - x;
}

fn main() {}
