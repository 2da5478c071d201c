//! E3 of Hone and Petrera (Section 3; Table 1, i = 3). The flow has the integrals `H = y/x` and
//! `K = (x^2 + y^2 + z^2)/2`, and the field `-P dK = -(1/c) Q dH`, where `c = 1/x^2`, and P and Q
//! are the Lie-Poisson brackets of A(3,3) and so(3). For the map, the block claims H and K (Table
//! 2), the density (Theorem 1), and compatible brackets (Theorem 2): `P` of Table 3, and `Q` of
//! Table 4 over c. In {y,z} and {z,x} of Q, Table 4 wrongly prints z in place of z^2 (erratum A1).
//! The zeros of the common factor `1 + eps z` of the map are removable poles.

mod flow;
mod solution;

use kahan_core::prelude::*;

use crate::entry::{Entry, row_of_the_tables};
use crate::solution::{point, trajectory};

pub use flow::FlowSolution;
pub use solution::Solution;

kahan! {
    /// E3, the Kahan map with the integrals of Table 2, row 3.
    pub struct E3;

    xdot = -x*z;
    ydot = -y*z;
    zdot = x^2 + y^2;

    integral H = y/x;
    integral K = 1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2));
    density rho = 2/(x*y*(x^2 + y^2 + z^2));
    bracket P {
        {y,z} = y*(1 + eps^2*(x^2 + y^2));
        {z,x} = -x*(1 + eps^2*(x^2 + y^2));
    }
    bracket Q {
        {x,y} = x^2*z;
        {y,z} = x^3*(1 - eps^2*z^2)/(1 + eps^2*(x^2 + y^2));
        {z,x} = x^2*y*(1 - eps^2*z^2)/(1 + eps^2*(x^2 + y^2));
    }
}

/// The entry of E3 in the catalog.
pub const ENTRY: Entry = row_of_the_tables!(
    3,
    "two Lie-Poisson structures, A(3,3) and so(3); solved by hyperbolic functions",
    " (corrected, erratum A1)"
);
