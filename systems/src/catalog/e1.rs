//! E1: section 3 of the paper; Table 1, i = 1; the Lie-Poisson pair A(3,3), sl(2,R).
//!
//! At eps = 0: `H = y/x`, `K = x z + y^2`, `c = 1/x^2`; the flow is `-P dK = -(1/c) Q dH`. Claims:
//! the integrals H and K of Table 2; the volume form c/(H K) of Theorem 1, with c, H, K at eps = 0;
//! the compatible Poisson pair of Theorem 2: `P` of Table 3, and `Q`, the tensor of Table 4 divided
//! by c. Not rational, so not claimed: the solution of the flow, `x = 1/T`, `y = beta/T`, `z =
//! gamma T - beta^2/T` with `T = t + alpha` (Table 5); that of the map, of the same kind (Theorem
//! 3). All components of N and det A share the factor `1 + eps x`: where it vanishes the map has a
//! removable pole.

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

/// The catalog's entry.
pub const ENTRY: Entry =
    row_of_the_tables!(1, "two Lie-Poisson structures, A(3,3) and sl(2,R); solved by rational functions");
