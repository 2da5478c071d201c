//! Hénon and Heiles' system with the Hamiltonian (p^2 + q^2 + a x^2 + b y^2)/2 + x^2 y - c y^3/3.
//! For generic a, b, c the degrees of the map's iterates grow exponentially; therefore the map is
//! not integrable. The map preserves the volume with density 1/det A, and a modified Hamiltonian.
//! The block claims H, which is 6 times the latter.

use kahan_core::prelude::*;

use crate::entry::{Entry, FOUND};

kahan! {
    /// Hénon and Heiles' system with the coefficients `a`, `b`, `c`.
    pub struct HenonHeiles {
        /// The square of the frequency of x.
        a,
        /// The square of the frequency of y.
        b,
        /// The coefficient of y² in q̇; 1 with a = b = 1 is the original system up to the sign of
        /// c.
        c
    }

    xdot = p;
    ydot = q;
    pdot = -a*x - 2*x*y;
    qdot = -b*y - x^2 + c*y^2;

    integral H = (3*p^2 + 3*q^2 + 6*x^2*y + 3*a*x^2 + 3*b*y^2 - 2*c*y^3 - 16*eps^2*x*p*q - 2*eps^2*y*p^2
        + 6*eps^2*y*q^2 - eps^2*a*p^2 + 3*eps^2*b*p^2 + 3*eps^2*a*q^2 - eps^2*b*q^2 - 4*eps^2*x^4
        - 4*eps^2*x^2*y^2 - 4*eps^2*a*x^2*y - 2*eps^2*b*x^2*y - eps^2*a^2*x^2 + 3*eps^2*a*b*x^2
        + 6*eps^2*b*y^3 + 3*eps^2*a*b*y^2 - eps^2*b^2*y^2 - 6*eps^2*c*y*p^2 + 2*eps^2*c*y*q^2
        - 4*eps^2*c*x^2*y^2 - 6*eps^2*a*c*x^2*y - 4*eps^2*c*y^4 - 2*eps^2*a*c*y^3 + 4*eps^4*x^2*p^2
        + 4*eps^4*x^2*q^2 - 2*eps^4*b*y*p^2 - 2*eps^4*b*y*q^2 - eps^4*a*b*p^2 - eps^4*a*b*q^2
        + 4*eps^4*a*b*x^2*y - eps^4*a^2*b*x^2 - 2*eps^4*b^2*y^3 + 4*eps^4*c*y^2*p^2 + 4*eps^4*c*y^2*q^2
        - eps^4*a*b^2*y^2 + 2*eps^4*a*c*y*p^2 + 2*eps^4*a*c*y*q^2 + 2*eps^4*a^2*c*x^2*y)/(1 + 2*eps^2*y
        + eps^2*a + eps^2*b - 2*eps^2*c*y - 4*eps^4*x^2 + 2*eps^4*b*y + eps^4*a*b - 4*eps^4*c*y^2
        - 2*eps^4*a*c*y);
    density rho = 1/(1 + 2*eps^2*y + eps^2*a + eps^2*b - 2*eps^2*c*y - 4*eps^4*x^2 + 2*eps^4*b*y
        + eps^4*a*b - 4*eps^4*c*y^2 - 2*eps^4*a*c*y);
}

/// The entry of Hénon and Heiles' system in the catalog.
pub const ENTRY: Entry = Entry::new(
    "henon-heiles",
    "HenonHeiles",
    "Hénon and Heiles' two coupled oscillators; chaos with an integral",
    include_str!("henon_heiles.rs"),
)
.named("Hénon–Heiles")
.with_parameters(&[(1, 1), (5, 4), (3, 4)])
.with_sources(&[("H", FOUND), ("rho", FOUND)]);
