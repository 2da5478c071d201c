//! The Weierstrass equation x'' = 6 x^2 - a, solved by the elliptic function with g2 = 2 a. The
//! flow is Hamiltonian: the field is `f = K grad(H0/6)`, where H0 is H at eps = 0 and
//! `K = [[0, 1], [-1, 0]]`. The map has the modified Hamiltonian H and the density 1/det A.
//! Compositions of higher order preserve neither of them.

use kahan_core::prelude::*;

use crate::entry::{Entry, FOUND};

kahan! {
    /// The Weierstrass equation `x'' = 6 x^2 - a` as a system.
    pub struct Weierstrass {
        /// Half the invariant g₂ of the elliptic function.
        a
    }

    xdot = y;
    ydot = 6*x^2 - a;

    integral H = (6*a*x + 3*y^2 - 12*x^3 - 4*eps^2*a^2 - 24*eps^2*a*x^2 + 12*eps^2*x*y^2)/(1 - 12*eps^2*x);
    density rho = 1/(1 - 12*eps^2*x);
}

/// The entry of the Weierstrass equation in the catalog.
pub const ENTRY: Entry = Entry::new(
    "weierstrass",
    "Weierstrass",
    "the equation of the Weierstrass function; elliptic curves in the plane",
    include_str!("weierstrass.rs"),
)
.named("Weierstrass’ equation")
.with_parameters(&[(5, 4)])
.with_sources(&[("H", FOUND), ("rho", FOUND)]);
