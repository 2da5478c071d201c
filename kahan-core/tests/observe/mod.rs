//! Compares observers with known results: the literature, closed forms, plain loops.

mod ensembles;
mod exponents;
mod first_times;
mod indicators;
mod jumps;
mod sections;

use kahan_core::prelude::*;

kahan! {
    /// Lorenz' system, whose step also has a form that divides by ε.
    pub(crate) struct Lorenz { sigma, rho, beta }
    xdot = sigma*(y - x);
    ydot = x*(rho - z) - y;
    zdot = x*y - beta*z;
}

kahan! {
    /// Hénon and Heiles' two coupled oscillators.
    pub(crate) struct HenonHeiles;
    xdot = p;
    ydot = q;
    pdot = -x - 2*x*y;
    qdot = -y - x^2 + y^2;
}

pub(crate) const LORENZ: Lorenz<f64> = Lorenz { sigma: 10.0, rho: 28.0, beta: 8.0 / 3.0 };
