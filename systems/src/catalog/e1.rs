//! E1 of Hone and Petrera (Section 3; Table 1, i = 1). The flow has the integrals `H = y/x` and
//! `K = x z + y^2`. Its field equals `-P dK` and also `-(1/c) Q dH`. Here `c = 1/x^2`, and P and Q
//! are the Lie-Poisson tensors of the Lie algebras A(3,3) and sl(2,R). For the map, the block
//! claims H and K (Table 2), the density (Theorem 1), and two compatible brackets of its own
//! (Theorem 2): `P` of Table 3, and `Q` of Table 4 divided by c. The numerators of the map and det
//! A have the common factor `1 + eps x`, whose zeros are removable poles.

mod solution;

use kahan_core::prelude::*;

use crate::entry::{Entry, row_of_the_tables};
use crate::solution::{point, trajectory};

pub use solution::{FlowSolution, Solution};

kahan! {
    /// E1, the Kahan map with the integrals of Table 2, row 1.
    pub struct E1;

    xdot = -x^2;
    ydot = -x*y;
    zdot = 2*y^2 + x*z;

    integral H = y/x;
    integral K = (x*z + y^2)/(1 - eps^2*x^2);
    density rho = 1/(x*y*(x*z + y^2));
    bracket P {
        {y,z} = y*(1 - eps^2*x^2);
        {z,x} = -x*(1 - eps^2*x^2);
    }
    bracket Q {
        {x,y} = x^3;
        {y,z} = x^2*(z + eps^2*x*(x*z + 2*y^2))/(1 - eps^2*x^2);
        {z,x} = 2*x^2*y;
    }
}

/// The entry of E1 in the catalog.
pub const ENTRY: Entry =
    row_of_the_tables!(1, "two Lie-Poisson structures, A(3,3) and sl(2,R); solved by rational functions");
