//! The Lorenz system, for comparison with systems whose structures are preserved. For generic s, r,
//! b, `kahan discover` finds no integral up to degree 9, and no density 1/P with P up to degree 8.

use kahan_core::prelude::*;

use crate::entry::Entry;

kahan! {
    /// The Lorenz system.
    pub struct Lorenz {
        /// The Prandtl number.
        s,
        /// The Rayleigh number over its critical value.
        r,
        /// The shape of the convection cell.
        b
    }

    xdot = s*(y - x);
    ydot = x*(r - z) - y;
    zdot = x*y - b*z;
}

/// The entry of the Lorenz system in the catalog.
pub const ENTRY: Entry =
    Entry::new("lorenz", "Lorenz", "the Lorenz system; nothing is conserved", include_str!("lorenz.rs"))
        .with_parameters(&[(10, 1), (28, 1), (11, 4)]);
