//! E5 of Hone and Petrera (Section 3; Table 1, i = 5). The flow has the integrals
//! `H = (x^2 + y^2)/2` and `K = x z + y^2`, and the field `-P dK = -(1/c) Q dH`, where `c = -1`,
//! and P and Q are the Lie-Poisson brackets of e(2) and sl(2,R). The block claims H and K (Table
//! 2), the density (Theorem 1), and compatible brackets (Theorem 2): `P` of Table 3, and `Q` of
//! Table 4 over c.

mod flow;
mod solution;

use kahan_core::prelude::*;

use crate::entry::{Entry, row_of_the_tables};
use crate::solution::{point, trajectory};

pub use flow::FlowSolution;
pub use solution::Solution;

kahan! {
    /// E5, the Kahan map with the integrals of Table 2, row 5.
    pub struct E5;

    xdot = x*y;
    ydot = -x^2;
    zdot = y*(2*x - z);

    integral H = 1/2*(x^2 + y^2)/(1 + eps^2*x^2);
    integral K = (x*z + y^2)/(1 + eps^2*x^2);
    density rho = -2/((x^2 + y^2)*(x*z + y^2));
    bracket P {
        {y,z} = x*(1 - eps^2*y^2);
        {z,x} = y*(1 + eps^2*x^2);
    }
    bracket Q {
        {x,y} = -x*(1 + eps^2*x^2);
        {y,z} = -(z - eps^2*x*(x*z + 2*y^2));
        {z,x} = -2*y*(1 + eps^2*x^2);
    }
}

/// The entry of E5 in the catalog.
pub const ENTRY: Entry =
    row_of_the_tables!(5, "two Lie-Poisson structures, e(2) and sl(2,R); solved by hyperbolic functions");
