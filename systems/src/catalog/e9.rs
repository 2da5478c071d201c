//! E9 of Hone and Petrera (Section 6.3), with the Lie-Poisson bracket of so(3) and one that depends
//! on xi. At xi = 1 the system is E3, at xi = -1 it is E4, and the block claims all structures of
//! these systems. At xi = 0, y is constant and the map is integrable. For other xi, the number of
//! digits of an exact point about triples in each step (Section 7). The block claims a density for
//! every xi, which is not in the paper. The flow has the integrals `y x^(-xi)` and
//! `(x^2 + y^2 + z^2)/2`. At xi = 1 the numerators and the denominator of the map have a common
//! factor `1 + eps z`, which is cancelled in the map of E3.

mod flow;
mod quadrature;
mod solution;

use kahan_core::prelude::*;

use crate::entry::Entry;
use crate::solution::{point, trajectory};

pub use flow::{Elementary, FlowSolution};
pub use quadrature::{Quadrature, fixed_points, sphere_radius};
pub use solution::Solution;

kahan! {
    /// E9, which joins E3 (`xi = 1`) and E4 (`xi = -1`).
    pub struct E9 {
        /// The exponent ξ of the integral y x^(−ξ) of the flow.
        xi
    }

    xdot = -x*z;
    ydot = -xi*y*z;
    zdot = x^2 + xi*y^2;

    density rho = 1/(x*y*(1 + (1 - xi)*eps^2*x^2 + xi*(xi - 1)*eps^2*y^2 - xi*eps^2*z^2));

    integral H3 = y/x when xi = 1;
    integral K3 = 1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2)) when xi = 1;
    density rho3 = 2/(x*y*(x^2 + y^2 + z^2)) when xi = 1;
    bracket P3 {
        {y,z} = y*(1 + eps^2*(x^2 + y^2));
        {z,x} = -x*(1 + eps^2*(x^2 + y^2));
    } when xi = 1;
    bracket Q3 {
        {x,y} = x^2*z;
        {y,z} = x^3*(1 - eps^2*z^2)/(1 + eps^2*(x^2 + y^2));
        {z,x} = x^2*y*(1 - eps^2*z^2)/(1 + eps^2*(x^2 + y^2));
    } when xi = 1;

    integral H4 = x*y/(1 + eps^2*(x^2 + y^2)) when xi = -1;
    integral K4 = 1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2)) when xi = -1;
    density rho4 = 2/(x*y*(x^2 + y^2 + z^2)) when xi = -1;
    bracket P4 {
        {y,z} = -y*(1 - eps^2*(x^2 - y^2));
        {z,x} = -x*(1 + eps^2*(x^2 - y^2));
    } when xi = -1;
    bracket Q4 {
        {x,y} = z*(1 + eps^2*(x^2 + y^2));
        {y,z} = x*(1 - eps^2*z^2);
        {z,x} = y*(1 - eps^2*z^2);
    } when xi = -1;
}

/// The entry of E9 in the catalog.
pub const ENTRY: Entry = Entry::new(
    "e9",
    "E9",
    "a family with parameter xi: E3 at xi = 1, E4 at xi = -1; not integrable for most other xi",
    include_str!("e9.rs"),
)
.with_parameters(&[(-5, 4)])
.with_flow(|parameters, start| {
    trajectory(FlowSolution::through(parameters.first()?, &point(start)?), FlowSolution::at)
})
.with_sources(&[
    ("rho", "Section 6.3, not stated there"),
    ("H3", "Section 6.3, xi = 1; Table 2, i = 3"),
    ("K3", "Section 6.3, xi = 1; Table 2, i = 3"),
    ("rho3", "Section 6.3, xi = 1; Theorem 1"),
    ("P3", "Section 6.3, xi = 1; Table 3, i = 3"),
    ("Q3", "Section 6.3, xi = 1; Table 4, i = 3 (corrected, erratum A1)"),
    ("H4", "Section 6.3, xi = -1; Table 2, i = 4"),
    ("K4", "Section 6.3, xi = -1; Table 2, i = 4"),
    ("rho4", "Section 6.3, xi = -1; Theorem 1"),
    ("P4", "Section 6.3, xi = -1; Table 3, i = 4"),
    ("Q4", "Section 6.3, xi = -1; Table 4, i = 4"),
]);
