//! Systems that several test modules share.

use kahan_core::prelude::*;

kahan! {
    /// The integrable field E6 of Hone and Petrera.
    pub(crate) struct E6;
    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);

    integral H = (x*z + y^2)/(1 - 3*eps^2*x*z);
    integral K = 1/2*(x^2 + y^2 + z^2)/(1 - 3*eps^2*x*z);
}

kahan! {
    pub(crate) struct E2;
    xdot = -x^2;
    ydot = x*y;
    zdot = -2*y^2 + x*z;
}

kahan! {
    pub(crate) struct EulerTop { a1, a2, a3 }
    xdot = a1*y*z;
    ydot = a2*z*x;
    zdot = a3*x*y;
}

kahan! {
    pub(crate) struct LotkaVolterra;
    xdot = x*(1 - y);
    ydot = y*(x - 1);
}

kahan! {
    pub(crate) struct Lorenz;
    xdot = 10*(y - x);
    ydot = x*(28 - z) - y;
    zdot = x*y - 8/3*z;
}

kahan! {
    /// A rotation around the origin. Each step turns by the angle 2 arctan ε.
    pub(crate) struct Turn;
    xdot = y;
    ydot = -x;
}

kahan! {
    /// The solution 1/(1/x₀ − t) becomes infinite at t = 1/x₀.
    pub(crate) struct Burst;
    xdot = x^2;
}

kahan! {
    /// Hénon and Heiles' two coupled oscillators.
    pub(crate) struct Henon;
    qdot = p;
    pdot = -q - 2*q*r;
    rdot = s;
    sdot = -r - q^2 + r^2;
}

kahan! {
    /// Field and Noyes' oregonator, a relaxation oscillation, with less stiff coefficients.
    pub(crate) struct Relaxation;
    xdot = 20*(y - x*y + x - x^2/500);
    ydot = (z - y - x*y)/20;
    zdot = (x - z)/6;
}
