//! E7 of Hone and Petrera (Section 6), with the Lie-Poisson bracket of sl(2,R) and one that depends
//! on xi. At xi = 1 the system is E1, at xi = -1 it is E2. The map has the integral
//! `(y/x) Gamma(xi/2 + u)/Gamma(1 - xi/2 + u)` with `u = 1/(2 eps x)`, which is rational for
//! integer xi. The block claims the density for every xi, and all structures of E1 and E2 at xi = 1
//! and -1. At xi = 2, 3, -2, -3 it claims the integral, without constant factors. At xi = 2 and 3
//! it also claims a bracket with this integral as Casimir function.

mod flow;
mod integrals;
mod recurrence;
mod solution;

use kahan_core::prelude::*;

use crate::entry::Entry;
use crate::solution::{point, trajectory};

pub use flow::FlowSolution;
pub use integrals::{bracket_of_h, integral_h, integral_k};
pub use recurrence::Recurrence;
pub use solution::Solution;

kahan! {
    /// E7, which joins E1 (`xi = 1`) and E2 (`xi = -1`).
    pub struct E7 {
        /// The exponent ξ of the integral y x^(−ξ) of the flow.
        xi
    }

    xdot = -x^2;
    ydot = -xi*x*y;
    zdot = 2*xi*y^2 + x*z;

    density rho = 1/(x*y*(1 - eps^2*x^2));

    integral H1 = y/x when xi = 1;
    integral K1 = (x*z + y^2)/(1 - eps^2*x^2) when xi = 1;
    density rho1 = 1/(x*y*(x*z + y^2)) when xi = 1;
    bracket P1 {
        {y,z} = y*(1 - eps^2*x^2);
        {z,x} = -x*(1 - eps^2*x^2);
    } when xi = 1;
    bracket Q1 {
        {x,y} = x^3;
        {y,z} = x^2*(z + eps^2*x*(x*z + 2*y^2))/(1 - eps^2*x^2);
        {z,x} = 2*x^2*y;
    } when xi = 1;

    integral H2 = x*y/(1 - eps^2*x^2) when xi = -1;
    integral K2 = (x*z + y^2)/(1 - eps^2*x^2) when xi = -1;
    density rho2 = 1/(x*y*(x*z + y^2)) when xi = -1;
    bracket P2 {
        {y,z} = -y*(1 + eps^2*x^2);
        {z,x} = -x*(1 - eps^2*x^2);
    } when xi = -1;
    bracket Q2 {
        {x,y} = x*(1 - eps^2*x^2);
        {y,z} = z + eps^2*x*(x*z + 2*y^2);
        {z,x} = 2*y*(1 - eps^2*x^2);
    } when xi = -1;

    integral H_at_2 = y/x^2 when xi = 2;
    integral H_at_3 = y*(1 - eps^2*x^2)/x^3 when xi = 3;
    integral H_at_minus_2 = x^2*y/(1 - 4*eps^2*x^2) when xi = -2;
    integral H_at_minus_3 = x^3*y/((1 - eps^2*x^2)*(1 - 9*eps^2*x^2)) when xi = -3;
    bracket P_at_2 {
        {y,z} = -2*y*(1 - eps^2*x^2);
        {z,x} = x*(1 - eps^2*x^2);
    } when xi = 2;
    bracket P_at_3 {
        {y,z} = -y*(3 - eps^2*x^2);
        {z,x} = x*(1 - eps^2*x^2);
    } when xi = 3;
}

/// The entry of E7 in the catalog.
pub const ENTRY: Entry = Entry::new(
    "e7",
    "E7",
    "a family with parameter xi between E1 (xi = 1) and E2 (xi = -1); a Gamma-function integral",
    include_str!("e7.rs"),
)
.with_parameters(&[(-5, 4)])
.with_flow(|parameters, start| {
    trajectory(FlowSolution::through(parameters.first()?, &point(start)?), FlowSolution::at)
})
.with_sources(&[
    ("rho", "Section 6 (dE7), volume form"),
    ("H1", "Section 6 (dE7), xi = 1; Table 2, i = 1"),
    ("K1", "Section 6 (dE7), xi = 1; Table 2, i = 1"),
    ("rho1", "Section 6 (dE7), xi = 1; Theorem 1"),
    ("P1", "Section 6 (dE7), xi = 1; Table 3, i = 1"),
    ("Q1", "Section 6 (dE7), xi = 1; Table 4, i = 1"),
    ("H2", "Section 6 (dE7), xi = -1; Table 2, i = 2"),
    ("K2", "Section 6 (dE7), xi = -1; Table 2, i = 2"),
    ("rho2", "Section 6 (dE7), xi = -1; Theorem 1"),
    ("P2", "Section 6 (dE7), xi = -1; Table 3, i = 2"),
    ("Q2", "Section 6 (dE7), xi = -1; Table 4, i = 2"),
    ("H_at_2", "Section 6 (dE7), H_7 at xi = 2"),
    ("H_at_3", "Section 6 (dE7), H_7 at xi = 3"),
    ("H_at_minus_2", "Section 6 (dE7), H_7 at xi = -2"),
    ("H_at_minus_3", "Section 6 (dE7), H_7 at xi = -3"),
    ("P_at_2", "Section 6 (dE7), bracket of H_7 at xi = 2"),
    ("P_at_3", "Section 6 (dE7), bracket of H_7 at xi = 3"),
]);
