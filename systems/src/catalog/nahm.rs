//! Nahm's equations of magnetic monopoles, reduced by octahedral symmetry (Hitchin, Manton and
//! Murray). The flow has the integral `y (2x + 3y) (x - y)^2`, whose level curves are elliptic. The
//! map preserves a quotient of this integral and a polynomial. Flow and map preserve the area
//! `dx dy/(y (2x + 3y) (x - y))`.

use kahan_core::prelude::*;

use crate::entry::{Entry, FOUND};

kahan! {
    /// Nahm's equations with the symmetry of the octahedron.
    pub struct OctahedralNahm;

    xdot = 2*x^2 - 12*y^2;
    ydot = -6*x*y - 4*y^2;

    integral H = y*(2*x + 3*y)*(x - y)^2/(1 - 40*eps^2*x^2 - 160*eps^2*y^2 + 144*eps^4*x^4
        - 3072*eps^4*x^3*y + 3712*eps^4*x^2*y^2 + 9216*eps^4*x*y^3);
    density rho = 1/(y*(2*x + 3*y)*(x - y));
    bracket P {
        {x,y} = y*(2*x + 3*y)*(x - y);
    }
}

/// The entry of Nahm's equations in the catalog.
pub const ENTRY: Entry = Entry::new(
    "nahm",
    "OctahedralNahm",
    "Nahm's equations of monopoles with the symmetry of the octahedron",
    include_str!("nahm.rs"),
)
.named("Nahm’s equations, octahedral")
.with_sources(&[("H", FOUND), ("rho", FOUND), ("P", FOUND)]);
