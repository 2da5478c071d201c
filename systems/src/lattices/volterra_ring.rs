//! Volterra's chain closed to a ring: each species eats one neighbour and is eaten by the other (V.
//! Volterra, 1931; M. Kac and P. van Moerbeke, Adv. Math. 16 (1975) 160–169).

use kahan_core::prelude::*;

kahan! {
    /// Volterra's chain closed to a ring; at three and four sites it is that of the catalog.
    pub struct VolterraRing;
    for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }
    integral S = sum(x[i]);
}
