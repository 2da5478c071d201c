//! The periodic Volterra lattice with three sites. The map preserves `x + y + z`, the volume
//! `dx dy dz/(x y z)` and `x y z/D`, where D = det A is `1 - eps^2 ((x+y+z)^2 - 4 (xy+yz+zx))`. At
//! large steps the terms of D cancel. Therefore this system tests the accuracy of steps in floats.

use kahan_core::prelude::*;

use crate::entry::{Entry, FOUND};

kahan! {
    /// The periodic Volterra lattice with three sites `x`, `y`, `z`.
    pub struct VolterraLattice;

    xdot = x*(y - z);
    ydot = y*(z - x);
    zdot = z*(x - y);

    density rho = 1/(x*y*z);
    integral S = x + y + z;
    integral K = x*y*z/(1 - eps^2*((x + y + z)^2 - 4*(x*y + y*z + z*x)));
}

/// The entry of this lattice in the catalog.
pub const ENTRY: Entry = Entry::new(
    "volterra",
    "VolterraLattice",
    "the periodic Volterra lattice with three sites",
    include_str!("volterra.rs"),
)
.named("Volterra lattice, three sites")
.with_sources(&[("rho", "from kahan discover's density 1/D and integral K"), ("S", FOUND), ("K", FOUND)]);
