//! The Zhukovsky-Volterra top, which is a gyrostat. For generic coefficients, `kahan discover`
//! finds no integral up to degree 9, and no density 1/P with P up to degree 8. If one of b1, b2, b3
//! is zero, the map has an integral. If two of them are zero, the map has two integrals and a
//! density. If all are zero, the system is the Euler top. The claims therefore have the conditions
//! b3 = 0, or b3 = 0 and b2 = 0.

use kahan_core::prelude::*;

use crate::entry::Entry;

kahan! {
    /// The top of Zhukovsky and Volterra.
    pub struct ZhukovskyVolterra {
        /// The coefficient of yz in ẋ.
        a1,
        /// The coefficient of zx in ẏ.
        a2,
        /// The coefficient of xy in ż.
        a3,
        /// The gyrostat's momentum about x.
        b1,
        /// The gyrostat's momentum about y.
        b2,
        /// The gyrostat's momentum about z.
        b3
    }

    xdot = a1*y*z + b3*y - b2*z;
    ydot = a2*z*x + b1*z - b3*x;
    zdot = a3*x*y + b2*x - b1*y;

    integral G = (2*b1*x + 2*b2*y + a2*x^2 - a1*y^2 + eps^2*a1*b1^2*z^2 - eps^2*b2^2*a2*z^2)/(1 - eps^2*a1*a2*z^2) when b3 = 0;
    integral H = (2*b1*x - a3*x^2 + a1*z^2 - eps^2*a1*b1^2*y^2)/(1 - eps^2*a1*a3*y^2) when b3 = 0, b2 = 0;
    integral K = (2*b1*x + a2*x^2 - a1*y^2 + eps^2*a1*b1^2*z^2)/(1 - eps^2*a1*a2*z^2) when b3 = 0, b2 = 0;
    density rho = 1/((1 - eps^2*a1*a3*y^2)*(1 - eps^2*a1*a2*z^2)) when b3 = 0, b2 = 0;
}

/// The entry of the Zhukovsky-Volterra top in the catalog.
pub const ENTRY: Entry = Entry::new(
    "zhukovsky",
    "ZhukovskyVolterra",
    "the Zhukovsky-Volterra gyrostat; integrable with two of its momenta zero",
    include_str!("zhukovsky.rs"),
)
.named("Zhukovsky–Volterra")
.with_parameters(&[(3, 2), (-5, 8), (7, 4), (1, 4), (-3, 8), (1, 2)])
.with_sources(&[
    ("G", "found by kahan discover at b3 = 0"),
    ("H", "found by kahan discover at b2 = b3 = 0"),
    ("K", "found by kahan discover at b2 = b3 = 0"),
    ("rho", "found by kahan discover at b2 = b3 = 0"),
]);
