//! E4 of Hone and Petrera (Section 3; Table 1, i = 4). The flow has the integrals `H = x y` and
//! `K = (x^2 + y^2 + z^2)/2`, and the field `-P dK = -(1/c) Q dH`, where `c = 1`, and P and Q are
//! the Lie-Poisson brackets of e(1,1) and so(3). The block claims H and K (Table 2), the density
//! (Theorem 1), and compatible brackets (Theorem 2): `P` of Table 3, and `Q` of Table 4 over c. In
//! the coordinates x - y, x + y, z the system is the Euler top with a = (-1, -1, 1).

mod flow;
mod normal_form;
mod solution;

use kahan_core::prelude::*;

use crate::entry::{Entry, row_of_the_tables};
use crate::solution::{point, trajectory};

pub use flow::FlowSolution;
pub use normal_form::Symmetry;
pub use solution::Solution;

kahan! {
    /// E4, the Kahan map with the integrals of Table 2, row 4.
    pub struct E4;

    xdot = -x*z;
    ydot = y*z;
    zdot = x^2 - y^2;

    integral H = x*y/(1 + eps^2*(x^2 + y^2));
    integral K = 1/2*(x^2 + y^2 + z^2)/(1 + eps^2*(x^2 + y^2));
    density rho = 2/(x*y*(x^2 + y^2 + z^2));
    bracket P {
        {y,z} = -y*(1 - eps^2*(x^2 - y^2));
        {z,x} = -x*(1 + eps^2*(x^2 - y^2));
    }
    bracket Q {
        {x,y} = z*(1 + eps^2*(x^2 + y^2));
        {y,z} = x*(1 - eps^2*z^2);
        {z,x} = y*(1 - eps^2*z^2);
    }
}

/// The entry of E4 in the catalog.
pub const ENTRY: Entry =
    row_of_the_tables!(4, "two Lie-Poisson structures, e(1,1) and so(3); solved by elliptic functions");
