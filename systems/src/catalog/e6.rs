//! E6 of Hone and Petrera (Section 3; Table 1, i = 6). The flow has the integrals `H = x z + y^2`
//! and `K = (x^2 + y^2 + z^2)/2`, and the field `-P dK = -(1/c) Q dH`, where `c = -1`, and P and Q
//! are the Lie-Poisson brackets of sl(2,R) and so(3). The block claims H and K (Table 2), the
//! density (Theorem 1), and compatible brackets (Theorem 2): `P` of Table 3, and `Q` of Table 4
//! over c. In the coordinates x - z, x + z, y the system is the Euler top with a = (1, -3, 1).

mod solution;

use kahan_core::prelude::*;

use crate::entry::{Entry, row_of_the_tables};
use crate::solution::{point, trajectory};

pub use solution::{FlowSolution, Solution};

kahan! {
    /// E6, the Kahan map with the integrals of Table 2, row 6.
    pub struct E6;

    xdot = y*(2*z - x);
    ydot = x^2 - z^2;
    zdot = y*(z - 2*x);

    integral H = (x*z + y^2)/(1 - 3*eps^2*x*z);
    integral K = 1/2*(x^2 + y^2 + z^2)/(1 - 3*eps^2*x*z);
    density rho = -2/((x*z + y^2)*(x^2 + y^2 + z^2));
    bracket P {
        {x,y} = x*(1 + 3*eps^2*y^2);
        {y,z} = z*(1 + 3*eps^2*y^2);
        {z,x} = 2*y*(1 - 3*eps^2*x*z);
    }
    bracket Q {
        {x,y} = -(z + 3/2*eps^2*x*(x^2 + y^2 - z^2));
        {y,z} = -(x + 3/2*eps^2*z*(z^2 + y^2 - x^2));
        {z,x} = -y*(1 - 3*eps^2*x*z);
    }
}

/// The entry of E6 in the catalog.
pub const ENTRY: Entry =
    row_of_the_tables!(6, "two Lie-Poisson structures, sl(2,R) and so(3); elliptic curves");
