//! Toda's chain in Flaschka's variables, a = ½ exp(−(q₊ − q)/2) and b = −p/2, for a particle with
//! position q and momentum p and the next particle's position q₊ (Phys. Rev. B 9 (1974) 1924–1925).

use kahan_core::prelude::*;

kahan! {
    /// Toda's chain closed to a ring: a is of the spring behind a particle, b of its momentum.
    ///
    /// The energy 2 Σ (b² + 2a²) is kept by the flow; its Poisson tensor depends on a, so that no
    /// constant stencil gives the equations, and the map keeps no energy that follows from it.
    pub struct Toda;
    for i in periodic {
        a[i]dot = a[i]*(b[i+1] - b[i]);
        b[i]dot = 2*(a[i]^2 - a[i-1]^2);
    }
    integral momentum = sum(b[i]);
}
