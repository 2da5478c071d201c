//! A composition at fixed ε, and its orbits.
//!
//! The stages lie in an array of fixed size, and therefore nothing is allocated.

use core::array::from_fn;
use core::fmt;

use crate::step::advance_by;
use crate::{
    Compensated, FloatScalar, Increments, KahanAt, KahanMap, Orbit, Scalar, Step, Stopped, Workspace,
};

use super::Composition;

/// A [`Composition`] of a map at a fixed ε, which is half the time step; see [`KahanAt::composed`].
#[derive(Clone, Copy)]
pub struct Composed<S: Step> {
    pub(super) stages: Palindrome<S>,
    pub(super) composition: Composition,
    eps: S::Scalar,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Palindrome<P> {
    /// The distinct stages. Entries from `len` on are copies of the middle stage.
    pub(super) steps: [P; MOST],
    pub(super) len: usize,
}

/// The maximum number of distinct stages.
pub(super) const MOST: usize = 9;

impl<P> Palindrome<P> {
    /// Creates a composition of `len` distinct stages, from 1 to 9; `step(k)` returns stage k.
    #[inline]
    pub(super) fn new(len: usize, step: impl Fn(usize) -> P) -> Self {
        Self { steps: from_fn(|k| step(k.min(len - 1))), len }
    }

    #[inline(always)]
    pub(super) fn in_order(&self) -> impl Iterator<Item = &P> {
        let distinct = &self.steps[..self.len];
        let last = 2 * distinct.len() - 2;
        (0..=last).map(move |k| &distinct[k.min(last - k)])
    }

    #[inline(always)]
    pub(super) fn map<'a, Q>(&'a self, of: impl Fn(&'a P) -> Q) -> Palindrome<Q> {
        Palindrome { steps: self.steps.each_ref().map(of), len: self.len }
    }
}

impl<S: Step> Composed<S> {
    fn new(composition: Composition, eps: S::Scalar, at: impl Fn(S::Scalar) -> S) -> Self {
        let gammas = composition.first_half;
        let stage = |k: usize| at(S::Scalar::constant(&gammas[k]) * eps.clone());
        Self { stages: Palindrome::new(gammas.len(), stage), composition, eps }
    }

    /// Returns the name, the order and the coefficients of this composition.
    pub fn composition(&self) -> Composition {
        self.composition
    }

    /// Returns ε, half the time step of the whole composition.
    pub fn eps(&self) -> &S::Scalar {
        &self.eps
    }

    /// Returns the orbit that starts at `x`. The orbit owns a copy of the prepared stages.
    #[inline]
    pub fn orbit(&self, x: S::State) -> Orbit<Self>
    where
        S: Clone,
    {
        Orbit::new(self.clone(), x)
    }

    /// Returns the state after one time step 2ε, which is infinite or NaN if a stage meets a pole.
    #[inline]
    pub fn step(&self, x: &S::State) -> S::State {
        let Some(next) = self.next(x, &mut Workspace::new()) else {
            unreachable!("compositions are of floats")
        };
        next
    }
}

impl<S: Step> Step for Composed<S> {
    type Scalar = S::Scalar;
    type State = S::State;

    fn dimension(&self) -> usize {
        self.stages.steps[0].dimension()
    }

    fn eps(&self) -> &S::Scalar {
        &self.eps
    }

    #[inline]
    fn advance(&self, x: &mut [S::Scalar], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        advance_by(x, steps, &self.eps, |state| self.next(state, workspace))
    }

    fn part(&self, eps: &S::Scalar, x: &mut [S::Scalar], workspace: &mut Workspace) -> Result<(), Stopped> {
        // All stages have the same map. They differ only in ε, which is passed to `first.part`.
        let [first, ..] = &self.stages.steps;
        let mut gammas = self.composition.coefficients();
        gammas.try_for_each(|gamma| first.part(&(S::Scalar::constant(gamma) * eps.clone()), x, workspace))
    }

    #[inline(always)]
    fn next(&self, x: &S::State, workspace: &mut Workspace) -> Option<S::State> {
        let mut next = x.clone();
        for stage in self.stages.in_order() {
            next = stage.next(&next, workspace)?;
        }
        Some(next)
    }
}

impl<S: Increments> Increments for Composed<S> {
    type Carried = S::Carried;

    #[inline(always)]
    fn next_with_carry(&self, x: &S::Carried, workspace: &mut Workspace) -> Option<S::Carried> {
        let mut next = x.clone();
        for stage in self.stages.in_order() {
            next = stage.next_with_carry(&next, workspace)?;
        }
        Some(next)
    }
}

impl<M, T, const N: usize> KahanAt<M, T, N>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
{
    /// Returns the map whose step is this composition of steps of the Kahan map. A composed step
    /// advances the time by 2ε, as a plain step does.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    /// use kahan_core::{Composition, Ensemble};
    ///
    /// kahan! {
    ///     /// Predator and prey.
    ///     pub struct LotkaVolterra;
    ///     xdot = x*(1 - y);
    ///     ydot = y*(x - 1);
    /// }
    ///
    /// let map = LotkaVolterra.at(0.05).composed(Composition::KAHAN_LI_8);
    /// let mut ponds = Ensemble::new(vec![vector![1.5, 1.0], vector![0.7, 0.7]]);
    /// ponds.advance(&map, 100);
    ///
    /// let alone = map.orbit(vector![1.5, 1.0]).nth(100).unwrap();
    /// assert!((ponds.point(0).unwrap() - alone).norm() < 1e-12);
    /// ```
    pub fn composed(&self, composition: Composition) -> Composed<Self> {
        Composed::new(composition, self.eps, |eps| self.map.at(eps))
    }
}

impl<M, T, const N: usize> Orbit<KahanAt<M, T, N>>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
{
    /// Replaces each step of this orbit by a composition, for a higher order. A composed step still
    /// advances the time by 2ε and yields one point. [`Composition`] lists conserved properties and
    /// cost.
    ///
    /// ```
    /// use kahan_core::Composition;
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// The equation ẍ = 6x² − 2, whose energy is cubic in x.
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
    pub fn composed(self, composition: Composition) -> Orbit<Composed<KahanAt<M, T, N>>> {
        self.with_map(|at| at.composed(composition), |state| state)
    }
}

impl<M, T, const N: usize> Orbit<Compensated<KahanAt<M, T, N>>>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
{
    /// Returns the compensated orbit of `composition` that starts at this orbit's state.
    #[inline]
    pub fn composed(self, composition: Composition) -> Orbit<Compensated<Composed<KahanAt<M, T, N>>>> {
        self.with_map(|Compensated(at)| Compensated(at.composed(composition)), |state| state)
    }
}

impl<S: Step> fmt::Debug for Composed<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { composition, eps, .. } = self;
        f.debug_struct("Composed").field("composition", composition).field("eps", eps).finish_non_exhaustive()
    }
}
