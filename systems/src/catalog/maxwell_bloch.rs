//! The Maxwell-Bloch equations of light in a two-level medium, for real amplitudes and without
//! losses. The variable x is the field, y the polarisation, and z the inversion. The flow has the
//! integrals `x^2/2 + z` and `y^2 + z^2`, and is Hamiltonian in two ways (David and Holm, 1992).
//! The map has deformations H and K of both integrals, a density rho, and compatible brackets
//! `{x,y} = I_z/rho`, `{y,z} = I_x/rho`, `{z,x} = I_y/rho`: `P` for I = H/2, `Q` for I = K/2.

use kahan_core::prelude::*;

use crate::entry::{Entry, FOUND};

kahan! {
    /// The Maxwell–Bloch equations: field `x`, polarisation `y`, inversion `z`.
    pub struct MaxwellBloch;

    xdot = y;
    ydot = x*z;
    zdot = -x*y;

    integral H = (y^2 + z^2)/(1 + eps^2*x^2);
    integral K = 2*z + x^2 - eps^2*y^2;
    density rho = 1/(1 + eps^2*x^2);
    bracket P {
        {x,y} = z;
        {y,z} = -eps^2*x*(y^2 + z^2)/(1 + eps^2*x^2);
        {z,x} = y;
    }
    bracket Q {
        {x,y} = 1 + eps^2*x^2;
        {y,z} = x*(1 + eps^2*x^2);
        {z,x} = -eps^2*y*(1 + eps^2*x^2);
    }
}

/// The entry of the Maxwell-Bloch equations in the catalog.
pub const ENTRY: Entry = Entry::new(
    "maxwell-bloch",
    "MaxwellBloch",
    "the Maxwell-Bloch equations of light in a medium of two levels",
    include_str!("maxwell_bloch.rs"),
)
.named("Maxwell–Bloch")
.with_sources(&[("H", FOUND), ("K", FOUND), ("rho", FOUND), ("P", FOUND), ("Q", FOUND)]);
