//! Clebsch's case (1871) of a rigid body in an ideal fluid, with angular momentum m and linear
//! momentum p. The block states Kirchhoff's equations with the energy
//! `(m.m + w1 p1^2 + w2 p2^2 + w3 p3^2)/2`. The flow has four quadratic integrals. The map has four
//! integrals (Petrera, Pfadler and Suris, arXiv:0808.3345). The block claims the density and one
//! integral, H, a quotient of quadratic polynomials. `kahan discover` finds the density, a second
//! integral, and another formula for H.

use kahan_core::prelude::*;

use crate::entry::{Entry, FOUND};

kahan! {
    /// Clebsch's system: angular momentum `m1`, `m2`, `m3`, linear momentum `p1`, `p2`, `p3`.
    pub struct Clebsch {
        /// The coefficient of p₁² in twice the energy.
        w1,
        /// The coefficient of p₂² in twice the energy.
        w2,
        /// The coefficient of p₃² in twice the energy.
        w3
    }

    m1dot = (w3 - w2)*p2*p3;
    m2dot = (w1 - w3)*p3*p1;
    m3dot = (w2 - w1)*p1*p2;
    p1dot = m3*p2 - m2*p3;
    p2dot = m1*p3 - m3*p1;
    p3dot = m2*p1 - m1*p2;

    integral H = (p1^2 + p2^2 + p3^2)/(1 - eps^2*(w1*p1^2 + w2*p2^2 + w3*p3^2));
    density rho = 1/(1 + eps^2*m1^2 + eps^2*m2^2 + eps^2*m3^2 - eps^2*w1*p1^2 + eps^2*w3*p1^2
        + eps^2*w1*p2^2 - 2*eps^2*w2*p2^2 + eps^2*w3*p2^2 + eps^2*w1*p3^2 - eps^2*w3*p3^2
        + eps^4*w1*m1^2*p1^2 - eps^4*w2*m1^2*p1^2 + eps^4*w1*m1^2*p2^2 - eps^4*w2*m1^2*p2^2
        + eps^4*w1*m1^2*p3^2 + eps^4*w2*m1^2*p3^2 - 2*eps^4*w3*m1^2*p3^2 + 2*eps^4*w1*m1*m2*p1*p2
        - 2*eps^4*w2*m1*m2*p1*p2 + 2*eps^4*w1*m1*m3*p1*p3 - 4*eps^4*w2*m1*m3*p1*p3
        + 2*eps^4*w3*m1*m3*p1*p3 - 2*eps^4*w1*m2^2*p1^2 + 2*eps^4*w2*m2^2*p1^2
        + 2*eps^4*w2*m2^2*p3^2 - 2*eps^4*w3*m2^2*p3^2 - 2*eps^4*w2*m2*m3*p2*p3
        + 2*eps^4*w3*m2*m3*p2*p3 - 2*eps^4*w1*m3^2*p1^2 + eps^4*w2*m3^2*p1^2 + eps^4*w3*m3^2*p1^2
        - eps^4*w2*m3^2*p2^2 + eps^4*w3*m3^2*p2^2 - eps^4*w2*m3^2*p3^2 + eps^4*w3*m3^2*p3^2
        - eps^4*w1^2*p1^4 + 2*eps^4*w1*w2*p1^4 - eps^4*w2^2*p1^4 - 2*eps^4*w1^2*p1^2*p2^2
        + 3*eps^4*w1*w2*p1^2*p2^2 + eps^4*w1*w3*p1^2*p2^2 - eps^4*w2^2*p1^2*p2^2
        - eps^4*w2*w3*p1^2*p2^2 - 2*eps^4*w1^2*p1^2*p3^2 + 2*eps^4*w1*w2*p1^2*p3^2
        + 2*eps^4*w1*w3*p1^2*p3^2 - 2*eps^4*w2^2*p1^2*p3^2 + 2*eps^4*w2*w3*p1^2*p3^2
        - 2*eps^4*w3^2*p1^2*p3^2 - eps^4*w1*w2*p2^4 + eps^4*w1*w3*p2^4 + eps^4*w2^2*p2^4
        - eps^4*w2*w3*p2^4 - eps^4*w1*w2*p2^2*p3^2 + eps^4*w1*w3*p2^2*p3^2 - eps^4*w2^2*p2^2*p3^2
        + 3*eps^4*w2*w3*p2^2*p3^2 - 2*eps^4*w3^2*p2^2*p3^2 - eps^4*w2^2*p3^4 + 2*eps^4*w2*w3*p3^4
        - eps^4*w3^2*p3^4 + eps^6*w1^2*m1^2*p1^2*p2^2 - 2*eps^6*w1*w2*m1^2*p1^2*p2^2
        + eps^6*w2^2*m1^2*p1^2*p2^2 + eps^6*w1^2*m1^2*p1^2*p3^2 - eps^6*w1*w2*m1^2*p1^2*p3^2
        - eps^6*w1*w3*m1^2*p1^2*p3^2 + eps^6*w2*w3*m1^2*p1^2*p3^2 + eps^6*w1*w2*m1^2*p2^2*p3^2
        - eps^6*w1*w3*m1^2*p2^2*p3^2 - eps^6*w2^2*m1^2*p2^2*p3^2 + eps^6*w2*w3*m1^2*p2^2*p3^2
        + eps^6*w1*w2*m1^2*p3^4 - eps^6*w1*w3*m1^2*p3^4 - eps^6*w2*w3*m1^2*p3^4
        + eps^6*w3^2*m1^2*p3^4 - 2*eps^6*w1^2*m1*m2*p1^3*p2 + 4*eps^6*w1*w2*m1*m2*p1^3*p2
        - 2*eps^6*w2^2*m1*m2*p1^3*p2 + 2*eps^6*w1*w2*m1*m2*p1*p2*p3^2
        - 2*eps^6*w1*w3*m1*m2*p1*p2*p3^2 - 2*eps^6*w2^2*m1*m2*p1*p2*p3^2
        + 2*eps^6*w2*w3*m1*m2*p1*p2*p3^2 - 2*eps^6*w1^2*m1*m3*p1^3*p3 + 2*eps^6*w1*w2*m1*m3*p1^3*p3
        + 2*eps^6*w1*w3*m1*m3*p1^3*p3 - 2*eps^6*w2*w3*m1*m3*p1^3*p3 - 4*eps^6*w1*w2*m1*m3*p1*p2^2*p3
        + 4*eps^6*w1*w3*m1*m3*p1*p2^2*p3 + 4*eps^6*w2^2*m1*m3*p1*p2^2*p3
        - 4*eps^6*w2*w3*m1*m3*p1*p2^2*p3 - 2*eps^6*w1*w2*m1*m3*p1*p3^3 + 2*eps^6*w1*w3*m1*m3*p1*p3^3
        + 2*eps^6*w2*w3*m1*m3*p1*p3^3 - 2*eps^6*w3^2*m1*m3*p1*p3^3 + eps^6*w1^2*m2^2*p1^4
        - 2*eps^6*w1*w2*m2^2*p1^4 + eps^6*w2^2*m2^2*p1^4 - 2*eps^6*w1*w2*m2^2*p1^2*p3^2
        + 2*eps^6*w1*w3*m2^2*p1^2*p3^2 + 2*eps^6*w2^2*m2^2*p1^2*p3^2 - 2*eps^6*w2*w3*m2^2*p1^2*p3^2
        + eps^6*w2^2*m2^2*p3^4 - 2*eps^6*w2*w3*m2^2*p3^4 + eps^6*w3^2*m2^2*p3^4
        + 2*eps^6*w1*w2*m2*m3*p1^2*p2*p3 - 2*eps^6*w1*w3*m2*m3*p1^2*p2*p3
        - 2*eps^6*w2^2*m2*m3*p1^2*p2*p3 + 2*eps^6*w2*w3*m2*m3*p1^2*p2*p3
        - 2*eps^6*w2^2*m2*m3*p2*p3^3 + 4*eps^6*w2*w3*m2*m3*p2*p3^3 - 2*eps^6*w3^2*m2*m3*p2*p3^3
        + eps^6*w1^2*m3^2*p1^4 - eps^6*w1*w2*m3^2*p1^4 - eps^6*w1*w3*m3^2*p1^4
        + eps^6*w2*w3*m3^2*p1^4 + eps^6*w1*w2*m3^2*p1^2*p2^2 - eps^6*w1*w3*m3^2*p1^2*p2^2
        - eps^6*w2^2*m3^2*p1^2*p2^2 + eps^6*w2*w3*m3^2*p1^2*p2^2 + eps^6*w1*w2*m3^2*p1^2*p3^2
        - eps^6*w1*w3*m3^2*p1^2*p3^2 - eps^6*w2*w3*m3^2*p1^2*p3^2 + eps^6*w3^2*m3^2*p1^2*p3^2
        + eps^6*w2^2*m3^2*p2^2*p3^2 - 2*eps^6*w2*w3*m3^2*p2^2*p3^2 + eps^6*w3^2*m3^2*p2^2*p3^2
        + eps^6*w1^3*p1^6 - 2*eps^6*w1^2*w2*p1^6 - eps^6*w1^2*w3*p1^6 + eps^6*w1*w2^2*p1^6
        + 2*eps^6*w1*w2*w3*p1^6 - eps^6*w2^2*w3*p1^6 + eps^6*w1^3*p1^4*p2^2
        - eps^6*w1^2*w2*p1^4*p2^2 - 2*eps^6*w1^2*w3*p1^4*p2^2 - eps^6*w1*w2^2*p1^4*p2^2
        + 4*eps^6*w1*w2*w3*p1^4*p2^2 + eps^6*w2^3*p1^4*p2^2 - 2*eps^6*w2^2*w3*p1^4*p2^2
        + eps^6*w1^3*p1^4*p3^2 - 2*eps^6*w1^2*w2*p1^4*p3^2 - eps^6*w1^2*w3*p1^4*p3^2
        + eps^6*w1*w2^2*p1^4*p3^2 + 2*eps^6*w1*w2*w3*p1^4*p3^2 - eps^6*w2^2*w3*p1^4*p3^2
        + eps^6*w1^2*w2*p1^2*p2^4 - eps^6*w1^2*w3*p1^2*p2^4 - 2*eps^6*w1*w2^2*p1^2*p2^4
        + 2*eps^6*w1*w2*w3*p1^2*p2^4 + eps^6*w2^3*p1^2*p2^4 - eps^6*w2^2*w3*p1^2*p2^4
        + eps^6*w1^2*w2*p1^2*p2^2*p3^2 - eps^6*w1^2*w3*p1^2*p2^2*p3^2
        - 3*eps^6*w1*w2^2*p1^2*p2^2*p3^2 + 4*eps^6*w1*w2*w3*p1^2*p2^2*p3^2
        - eps^6*w1*w3^2*p1^2*p2^2*p3^2 + 2*eps^6*w2^3*p1^2*p2^2*p3^2
        - 3*eps^6*w2^2*w3*p1^2*p2^2*p3^2 + eps^6*w2*w3^2*p1^2*p2^2*p3^2 - eps^6*w1*w2^2*p1^2*p3^4
        + 2*eps^6*w1*w2*w3*p1^2*p3^4 - eps^6*w1*w3^2*p1^2*p3^4 + eps^6*w2^2*w3*p1^2*p3^4
        - 2*eps^6*w2*w3^2*p1^2*p3^4 + eps^6*w3^3*p1^2*p3^4 - eps^6*w1*w2^2*p2^4*p3^2
        + 2*eps^6*w1*w2*w3*p2^4*p3^2 - eps^6*w1*w3^2*p2^4*p3^2 + eps^6*w2^3*p2^4*p3^2
        - 2*eps^6*w2^2*w3*p2^4*p3^2 + eps^6*w2*w3^2*p2^4*p3^2 - 2*eps^6*w1*w2^2*p2^2*p3^4
        + 4*eps^6*w1*w2*w3*p2^2*p3^4 - 2*eps^6*w1*w3^2*p2^2*p3^4 + eps^6*w2^3*p2^2*p3^4
        - eps^6*w2^2*w3*p2^2*p3^4 - eps^6*w2*w3^2*p2^2*p3^4 + eps^6*w3^3*p2^2*p3^4
        - eps^6*w1*w2^2*p3^6 + 2*eps^6*w1*w2*w3*p3^6 - eps^6*w1*w3^2*p3^6 + eps^6*w2^2*w3*p3^6
        - 2*eps^6*w2*w3^2*p3^6 + eps^6*w3^3*p3^6);
}

/// The entry of Clebsch's system in the catalog.
pub const ENTRY: Entry = Entry::new(
    "clebsch",
    "Clebsch",
    "Clebsch's case of a rigid body in an ideal fluid; four integrals in six variables",
    include_str!("clebsch.rs"),
)
.named("Clebsch’s system")
.with_parameters(&[(1, 2), (5, 4), (7, 4)])
.with_sources(&[("H", "found by kahan discover, then made symmetric"), ("rho", FOUND)]);
