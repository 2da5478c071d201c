//! Claims with sums over all sites are proved or refuted for every number of sites.

use kahan_core::prelude::*;

kahan! {
    struct Quadratic;
    for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }
    integral S = sum(x[i]^2);
}

kahan! {
    struct Ends;
    for i in open { u[i]dot = u[i+1] - 2*u[i] + u[i-1]; }
    integral S = sum(u[i]);
}

kahan! {
    struct NoEnds;
    for i in periodic { u[i]dot = u[i+1] - 2*u[i] + u[i-1]; }
    integral S = sum(u[i]);
}

kahan! {
    struct NotEnergy;
    for i in periodic { u[i]dot = u[i+1]^2 - u[i-1]^2; }
    hamiltonian H = sum(u[i]^3 + u[i]*u[i+1]);
}

kahan! {
    struct NotAtTheEnds;
    for i in open { u[i]dot = u[i+1] - u[i-1] + u[i]; }
    hamiltonian H = sum(u[i]^2);
}

kahan! {
    struct Quartic;
    for i in periodic { u[i]dot = u[i+1] - u[i-1]; }
    hamiltonian H = sum(u[i]^4);
}

kahan! {
    struct NoSum;
    for i in periodic { u[i]dot = u[i+1] - u[i-1]; }
    integral S = u[i];
}

kahan! {
    struct Nested;
    for i in periodic { u[i]dot = u[i+1] - u[i-1]; }
    integral S = sum(u[i] + sum(u[i]));
}

kahan! {
    struct Factor;
    for i in periodic { u[i]dot = u[i+1] - u[i-1]; }
    integral S = u[i]*sum(u[i]);
}

kahan! {
    struct Nothing { c }
    for i in periodic { u[i]dot = c*(u[i+1] - u[i-1]); }
    integral S = sum(c);
}

kahan! {
    struct Density;
    for i in periodic { u[i]dot = u[i+1] - u[i-1]; }
    density rho = 1;
}

kahan! {
    struct Conditional { c }
    for i in periodic { u[i]dot = c*(u[i+1] - u[i-1]); }
    integral S = sum(u[i]) when c = 1;
}

kahan! {
    struct Plain;
    xdot = y;
    ydot = -x;
    hamiltonian H = x^2 + y^2;
}

fn main() {}
