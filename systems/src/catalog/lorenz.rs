//! The Lorenz system, a negative control: `kahan discover` finds nothing; not in the paper.
//!
//! No integral of degree up to 9 and no density 1/P with P of degree up to 8 shows for generic s,
//! r, b, and the degrees of the iterates triple. So there is nothing to claim.

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

/// The catalog's entry.
pub const ENTRY: Entry =
    Entry::new("lorenz", "Lorenz", "the Lorenz system; nothing is conserved", include_str!("lorenz.rs"))
        .with_parameters(&[(10, 1), (28, 1), (11, 4)]);
