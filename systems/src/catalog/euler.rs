//! The Euler top (Hone and Petrera, Section 2). The flow has the integrals g1 x^2 + g2 y^2 + g3 z^2
//! for all numbers g1, g2, g3 with g1 a1 + g2 a2 + g3 a3 = 0. With `X = 1 - eps^2 a2 a3 x^2`,
//! `Y = 1 - eps^2 a3 a1 y^2` and `Z = 1 - eps^2 a1 a2 z^2`, the map has the integrals `Y/Z` and
//! `Z/X`, and the density `1/Z^2`. A density 1/phi and an integral I give the bracket
//! `({x,y}, {y,z}, {z,x}) = phi (I_z, I_x, I_y)` with derivatives I_x, I_y, I_z. The brackets `P`
//! and `Q` have `I = Y/(2 eps^2 a1 Z)` and `I = -X/(2 eps^2 a2 Z)`. They are compatible, because
//! phi is equal.

mod solution;

use kahan_core::prelude::*;

use crate::entry::Entry;
use crate::solution::{point, trajectory};

pub use solution::{FlowSolution, Reduction, Solution};

kahan! {
    /// The Euler top with the coefficients `a1`, `a2`, `a3`.
    pub struct EulerTop {
        /// The coefficient α₁ of yz in ẋ.
        a1,
        /// The coefficient α₂ of zx in ẏ.
        a2,
        /// The coefficient α₃ of xy in ż.
        a3
    }

    xdot = a1*y*z;
    ydot = a2*z*x;
    zdot = a3*x*y;

    integral H = (1 - eps^2*a3*a1*y^2)/(1 - eps^2*a1*a2*z^2);
    integral K = (1 - eps^2*a1*a2*z^2)/(1 - eps^2*a2*a3*x^2);
    density rho = 1/(1 - eps^2*a1*a2*z^2)^2;
    bracket P {
        {x,y} = a2*z*(1 - eps^2*a3*a1*y^2);
        {z,x} = -a3*y*(1 - eps^2*a1*a2*z^2);
    }
    bracket Q {
        {x,y} = -a1*z*(1 - eps^2*a2*a3*x^2);
        {y,z} = a3*x*(1 - eps^2*a1*a2*z^2);
    }
}

/// The entry of the Euler top in the catalog.
pub const ENTRY: Entry = Entry::new(
    "euler",
    "EulerTop",
    "the Euler top, a rigid body that turns freely about its centre of mass",
    include_str!("euler.rs"),
)
.named("Euler top")
.with_parameters(&[(3, 2), (-5, 8), (7, 4)])
.with_flow(|parameters, start| {
    trajectory(FlowSolution::through(parameters.try_into().ok()?, &point(start)?), FlowSolution::at)
})
.with_sources(&[
    ("H", "Section 2, Euler top, not stated there"),
    ("K", "Section 2, Euler top, not stated there"),
    ("rho", "Section 2, Euler top, not stated there"),
    ("P", "Section 2, from rho and H"),
    ("Q", "Section 2, from rho and 1/K"),
]);
