//! The Lotka-Volterra system (Hone and Petrera, Section 1), with prey x and predators y. The flow
//! has the bracket `{x,y} = x y`, and the transcendental integral `log(x y) - (x + y)`. The map
//! preserves the bracket and the area `dx dy/(x y)` for every eps. The map has a rational integral
//! H only for eps = 1 and eps = -1. For other nonzero eps, the number of digits of an exact point
//! about doubles in each step (Section 7). At eps = 1 the x of an orbit satisfies
//! `x_{n+1} x_{n-1} = x_n (2 - x_n)`, and an orbit alternates between two conics (erratum B8).

use kahan_core::prelude::*;

use crate::entry::Entry;

kahan! {
    /// The Lotka–Volterra system: prey `x`, predators `y`.
    pub struct LotkaVolterra;

    xdot = x*(1 - y);
    ydot = y*(x - 1);

    density rho = 1/(x*y);
    bracket P {
        {x,y} = x*y;
    }
    integral H_forward = x^2/y^2 + y^2/x^2 + 4*(1/x - 1/y)^2*(1 - x - y) when eps = 1;
    integral H_backward = x^2/y^2 + y^2/x^2 + 4*(1/x - 1/y)^2*(1 - x - y) when eps = -1;
}

/// The entry of the Lotka-Volterra system in the catalog.
pub const ENTRY: Entry = Entry::new(
    "lv",
    "LotkaVolterra",
    "the Lotka-Volterra system of prey and predators",
    include_str!("lotka_volterra.rs"),
)
.named("Lotka–Volterra")
.with_sources(&[
    ("rho", "Section 1, symplectic form"),
    ("P", "Section 1, Poisson bracket"),
    ("H_forward", "Section 1, integral at eps = 1"),
    ("H_backward", "Section 1, integral at eps = -1"),
]);
