//! Blocks with several mistakes at once.

use kahan_core::prelude::*;

// A mistake that follows from another is not reported.
kahan! {
    pub struct BrokenNameUsedByOthers { k }
    const c = 1/0;
    xdot = c*y + k;
    y = x;
    integral H = c*x + y;
    integral K = H^2;
}

// The entries of a bracket are checked one by one.
kahan! {
    pub struct EntriesOfABracket;
    xdot = y;
    ydot = -x;
    bracket P { {x,x} = 1; {x,z} = 1; {y,x} = w; {x,y} = 1; }
}

// Every claim is proved or refuted.
kahan! {
    pub struct FalseClaims;
    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;
    integral H = y/x;
    integral K = x*z + y^2;
    density rho = 1/x;
    bracket P { {x,y} = 1; }
}

// The header, an equation and a claim have one mistake each.
kahan! {
    pub struct HeaderEquationClaim { k: f64 }
    xdot = -k**x;
    ydot = x;
    integral H x^2;
}

// All unknown names of one equation are reported, each once.
kahan! {
    pub struct NamesInOneEquation;
    xdot = a*x + b*y + a;
    ydot = x + a;
}

// Each equation is read, even after mistakes in earlier ones.
kahan! {
    pub struct ThreeEquations { k }
    xdot = -sin(x);
    ydot = 2y - k;
    zdot = x*y*z;
}

fn main() {}
