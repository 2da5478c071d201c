//! E8 of Hone and Petrera (Section 6). The flow has the integrals `H = x e^(-y/x)` and
//! `K = x z + y^2`, and its field equals `-P dK` and also `-(1/c) Q dH`. Here P and Q are
//! Lie-Poisson brackets, and `c = -e^(-y/x)/x` (erratum A2). The block claims the density, which
//! the paper omits. The map has the integral `y/x + digamma(1/2 + u)` with `u = 1/(2 eps x)`, and a
//! second integral that is a series.

mod flow;
mod integrals;
mod recurrence;
mod solution;

use kahan_core::prelude::*;

use crate::entry::Entry;
use crate::solution::{point, trajectory};

pub use flow::FlowSolution;
pub use integrals::{integral_h, integral_k};
pub use recurrence::Recurrence;
pub use solution::Solution;

kahan! {
    /// E8, whose integral is a digamma function.
    pub struct E8;

    xdot = -x^2;
    ydot = -x*(x + y);
    zdot = 2*y*(x + y) + x*z;

    density rho = 1/(x^2*(1 - eps^2*x^2));
}

/// The entry of E8 in the catalog.
pub const ENTRY: Entry =
    Entry::new("e8", "E8", "a Lie-Poisson pair with a digamma-function integral", include_str!("e8.rs"))
        .with_flow(|_, start| trajectory(FlowSolution::through(&point(start)?), FlowSolution::at))
        .with_sources(&[("rho", "Section 6 (dE8), not stated there")]);
