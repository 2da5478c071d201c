//! Volterra's chain with two free ends (M. Kac and P. van Moerbeke, Adv. Math. 16 (1975) 160–169).

use kahan_core::prelude::*;

kahan! {
    /// Volterra's chain with two ends.
    pub struct VolterraChain;
    for i in open { x[i]dot = x[i]*(x[i+1] - x[i-1]); }
    integral S = sum(x[i]);
}
