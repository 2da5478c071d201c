//! The Lagrange top in the body frame: angular momentum m, angular velocity (m1, m2, al m3),
//! direction p of gravity. With `d = al (1-al) m3^2 - g p3`, `v = (al-1) m3 (m1,m2) + g (p1,p2)`,
//! `w = m1 v1 + m2 v2`, `M = (2 al - 1) m3` and `D1 = 1 + eps^2 d`, the map preserves m3 and
//!
//! - `H = m1^2 + m2^2 - 2 d - eps^2 |v|^2`,
//! - `J = (w - M d)/D1`,
//! - `C = (|v|^2 + d^2 + eps^2 J^2)/(1 + eps^2 (m1^2 + m2^2) + eps^2 (M + eps^2 J)^2)`.
//!
//! The density is `1/(D1 F)`, where F is the denominator of C. At eps = 0 the integrals H, J and C
//! are functions of the energy, m·p, p·p and m3.

use kahan_core::prelude::*;

use crate::entry::{Entry, FOUND};

kahan! {
    /// The Lagrange top: angular momentum `m1`, `m2`, `m3`, direction of gravity `p1`, `p2`, `p3`.
    pub struct LagrangeTop {
        /// The coefficient of the axial momentum in the angular velocity, where that of the others
        /// is 1.
        al,
        /// The torque of gravity.
        g
    }

    m1dot = (al - 1)*m2*m3 + g*p2;
    m2dot = (1 - al)*m1*m3 - g*p1;
    m3dot = 0;
    p1dot = al*p2*m3 - p3*m2;
    p2dot = p3*m1 - al*p1*m3;
    p3dot = p1*m2 - p2*m1;

    integral H = m1^2 + m2^2 - 2*(al*(1 - al)*m3^2 - g*p3)
        - eps^2*(((al - 1)*m3*m1 + g*p1)^2 + ((al - 1)*m3*m2 + g*p2)^2);
    integral J = ((al - 1)*m3*(m1^2 + m2^2) + g*(m1*p1 + m2*p2) - (2*al - 1)*m3*(al*(1 - al)*m3^2 - g*p3))
        /(1 + eps^2*(al*(1 - al)*m3^2 - g*p3));
    integral C = ((1 + eps^2*(al*(1 - al)*m3^2 - g*p3))^2
            *(((al - 1)*m3*m1 + g*p1)^2 + ((al - 1)*m3*m2 + g*p2)^2 + (al*(1 - al)*m3^2 - g*p3)^2)
        + eps^2*((al - 1)*m3*(m1^2 + m2^2) + g*(m1*p1 + m2*p2) - (2*al - 1)*m3*(al*(1 - al)*m3^2 - g*p3))^2)
        /((1 + eps^2*(al*(1 - al)*m3^2 - g*p3))^2*(1 + eps^2*(m1^2 + m2^2))
        + eps^2*((2*al - 1)*m3 + eps^2*((al - 1)*m3*(m1^2 + m2^2) + g*(m1*p1 + m2*p2)))^2);
    density rho = (1 + eps^2*(al*(1 - al)*m3^2 - g*p3))
        /((1 + eps^2*(al*(1 - al)*m3^2 - g*p3))^2*(1 + eps^2*(m1^2 + m2^2))
        + eps^2*((2*al - 1)*m3 + eps^2*((al - 1)*m3*(m1^2 + m2^2) + g*(m1*p1 + m2*p2)))^2);
}

/// The entry of the Lagrange top in the catalog.
pub const ENTRY: Entry = Entry::new(
    "lagrange",
    "LagrangeTop",
    "the Lagrange top, a heavy symmetric rigid body; four integrals in six variables",
    include_str!("lagrange.rs"),
)
.named("Lagrange top")
.with_parameters(&[(3, 2), (5, 8)])
.with_sources(&[
    ("H", FOUND_TIDIED),
    ("J", FOUND),
    ("C", FOUND_TIDIED),
    ("rho", "from kahan discover's C: its denominator, and the factor D1 of det A"),
]);

const FOUND_TIDIED: &str = "found by kahan discover, then simplified by the other integrals";
