//! Orbits of higher order.

use crate::map::Accumulation;
use crate::{FloatScalar, KahanMap, Orbit, Single};

use super::{Composed, Composition};

impl<M, T, A, const N: usize> Orbit<M, T, N, Single, A>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
    A: Accumulation,
{
    /// The same orbit with each step replaced by a composition of steps with γ₁ε, …, γₛε, which has
    /// a higher order. It goes on from where this orbit is; every stage is prepared once.
    ///
    /// A step still takes the time 2ε and yields one point. What survives and what does not, and
    /// the cost, are said at [`Composition`].
    ///
    /// ```
    /// use kahan_core::Composition;
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// A pendulum's cubic neighbour, ẍ = 6x² − 2.
    ///     pub struct Weierstrass;
    ///     xdot = y;
    ///     ydot = 6*x^2 - 2;
    /// }
    ///
    /// let energy = |x: SVector<f64, 2>| x[1] * x[1] / 2.0 - 2.0 * x[0].powi(3) + 2.0 * x[0];
    /// let start = vector![-0.5, 0.2];
    /// let orbit = Weierstrass.orbit(start, 0.01).composed(Composition::KAHAN_LI_8).compensated();
    /// for x in orbit.take(1000) {
    ///     assert!((energy(x) - energy(start)).abs() < 1e-14);
    /// }
    /// ```
    #[inline]
    pub fn composed(self, composition: Composition) -> Orbit<M, T, N, Composed, A> {
        let (map, eps) = self.parts();
        let stages = composition.stages_of(eps, |eps| map.prepare(&eps));
        self.with_stages(stages)
    }
}
