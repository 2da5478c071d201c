//! The periodic Volterra lattice with four sites. The flow has the integrals x + y + z + w, x z and
//! y w. The map preserves the sum, the two products divided by polynomials that depend on eps, and
//! the volume dx dy dz dw/(x y z w). Compositions of higher order preserve only the sum and the
//! volume.

use kahan_core::prelude::*;

use crate::entry::{Entry, FOUND};

kahan! {
    /// The periodic Volterra lattice with four sites `x`, `y`, `z`, `w`.
    pub struct VolterraFour;

    xdot = x*(y - w);
    ydot = y*(z - x);
    zdot = z*(w - y);
    wdot = w*(x - z);

    integral S = x + y + z + w;
    integral H = x*z/(1 - eps^2*y^2 + 2*eps^2*y*w - eps^2*w^2);
    integral K = y*w/(1 - eps^2*x^2 + 2*eps^2*x*z + 2*eps^2*y*w - eps^2*z^2);
    density rho = 1/(x*y*z*w);
}

/// The entry of this lattice in the catalog.
pub const ENTRY: Entry = Entry::new(
    "volterra4",
    "VolterraFour",
    "the periodic Volterra lattice with four sites",
    include_str!("volterra4.rs"),
)
.named("Volterra lattice, four sites")
.with_sources(&[("S", FOUND), ("H", FOUND), ("K", FOUND), ("rho", FOUND)]);
