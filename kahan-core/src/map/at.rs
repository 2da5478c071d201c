//! A map, or a composition of it, at a fixed ε.
//!
//! In: a map and ε, once. Out: steps that take a state only. It owns map, ε and what depends on
//! nothing else, borrows nothing, allocates nothing and holds no `dyn`.

use core::fmt;

use nalgebra::{SMatrix, SVector};

use crate::step::error::pole;
use crate::{PreparedStep, Room, Scalar, SingularStep, Slice, Step, Stopped};

use super::{KahanMap, Method, Orbit, Pivot, Single};

/// The Kahan map M at one ε, half the time step; made by [`KahanMap::at`]. A step of it is one of
/// the map, or, of a [`composed`](Self::composed) one, several.
///
/// What depends on ε and the parameters alone is computed once, when this is made; quotients are
/// left to the step, where a zero below shows as a pole. Its type can be written out, so a struct
/// of yours can hold it:
///
/// ```
/// use kahan_core::KahanAt;
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// Predator and prey, at any rate of change.
///     pub struct Prey { rate }
///     xdot = rate*x*(1 - y);
///     ydot = rate*y*(x - 1);
/// }
///
/// struct Pond {
///     map: KahanAt<Prey<f64>, f64, 2>,
///     state: SVector<f64, 2>,
/// }
///
/// let mut pond = Pond { map: Prey { rate: 0.5 }.at(0.125), state: vector![1.5, 1.0] };
/// for _ in 0..100 {
///     pond.state = pond.map.step(&pond.state);
/// }
/// assert!(pond.state.iter().all(|entry| *entry > 0.0));
/// ```
#[derive(Clone, Copy)]
pub struct KahanAt<M, T, const N: usize, K = Single>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
{
    pub(crate) map: M,
    pub(crate) eps: T,
    pub(crate) stages: K::Stages<M::Prepared>,
}

impl<M, T, K, const N: usize> KahanAt<M, T, N, K>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
{
    /// The map.
    pub fn map(&self) -> &M {
        &self.map
    }

    /// ε, half the time step.
    pub fn eps(&self) -> &T {
        &self.eps
    }

    /// The orbit that begins with `x`; it owns a copy of the prepared step.
    #[inline]
    pub fn orbit(&self, x: SVector<T, N>) -> Orbit<M, T, N, K> {
        Orbit::begin(self.map.clone(), self.eps.clone(), self.stages.clone(), x)
    }
}

impl<M, T, const N: usize> KahanAt<M, T, N>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
    #[inline]
    pub(crate) fn new(map: M, eps: T) -> Self {
        let stages = map.prepare(&eps);
        Self { map, eps, stages }
    }

    /// The prepared step, for code that finishes steps in its own way (in lanes, compensated).
    pub fn prepared(&self) -> &M::Prepared {
        &self.stages
    }

    /// x̃, as [`KahanMap::step`] and bit for bit the same.
    ///
    /// # Panics
    /// At a pole, for exact scalars.
    #[inline]
    pub fn step(&self, x: &SVector<T, N>) -> SVector<T, N> {
        match self.stages.next(x) {
            Some(next) => next,
            None => pole(&self.eps),
        }
    }

    /// x̃ with a promise or why there is none, as [`KahanMap::try_step`].
    ///
    /// # Errors
    /// [`SingularStep`] at a pole, at a point that is not finite, and beyond the scalar's range.
    #[inline(always)]
    pub fn try_step(&self, x: &SVector<T, N>) -> Result<SVector<T, N>, SingularStep>
    where
        T: Pivot,
    {
        self.map.try_prepared(&self.stages, x, &self.eps)
    }

    /// ∂x̃/∂x, as [`KahanMap::jacobian`].
    ///
    /// # Panics
    /// At a pole, for exact scalars.
    pub fn jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        self.map.jacobian(x, self.eps.clone())
    }
}

impl<M, T, K, const N: usize> Step for KahanAt<M, T, N, K>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
{
    type Scalar = T;
    type State = SVector<T, N>;

    fn dimension(&self) -> usize {
        N
    }

    fn eps(&self) -> &T {
        &self.eps
    }

    #[inline]
    fn advance(&self, x: &mut [T], steps: u64, _room: &mut Room) -> Result<(), Stopped> {
        advance::<K, _, T, N>(&self.stages, x, steps, &self.eps)
    }

    fn part(&self, eps: &T, x: &mut [T], _room: &mut Room) -> Result<(), Stopped> {
        let stages = K::at(&self.stages, eps, |eps| self.map.prepare(eps));
        advance::<K, _, T, N>(&stages, x, 1, eps)
    }

    #[inline(always)]
    fn next(&self, x: &SVector<T, N>, _room: &mut Room) -> Option<SVector<T, N>> {
        next::<K, _, T, N>(&self.stages, x)
    }
}

/// x̃ by all stages; `None` at a pole of an exact scalar.
#[inline(always)]
fn next<K, P, T, const N: usize>(stages: &K::Stages<P>, x: &SVector<T, N>) -> Option<SVector<T, N>>
where
    K: Method,
    P: PreparedStep<T, N>,
    T: Scalar,
{
    let mut next = x.clone();
    K::run(stages, |step| {
        next = step.next(&next)?;
        Some(())
    })?;
    Some(next)
}

/// Replaces `x` by the state so many steps later, or as many as there are.
#[inline(always)]
fn advance<K, P, T, const N: usize>(
    stages: &K::Stages<P>,
    x: &mut [T],
    steps: u64,
    eps: &T,
) -> Result<(), Stopped>
where
    K: Method,
    P: PreparedStep<T, N>,
    T: Scalar,
{
    // A state of its own, which the compiler can keep in registers.
    let mut state = <SVector<T, N> as Slice<T>>::zeros(x.len());
    state.as_mut_slice().clone_from_slice(x);
    let mut made = 0;
    while made < steps
        && let Some(after) = next::<K, P, T, N>(stages, &state)
    {
        state = after;
        made += 1;
    }
    x.clone_from_slice(state.as_slice());
    if made == steps {
        return Ok(());
    }
    Err(Stopped { steps: made, why: SingularStep::pole(eps.approximate()) })
}

/// Two are equal where map and ε are; the rest follows from them.
impl<M, T, const N: usize> PartialEq for KahanAt<M, T, N>
where
    M: KahanMap<T, N> + PartialEq,
    T: Scalar,
{
    fn eq(&self, other: &Self) -> bool {
        self.map == other.map && self.eps == other.eps
    }
}

impl<M, T, K, const N: usize> fmt::Debug for KahanAt<M, T, N, K>
where
    M: KahanMap<T, N> + fmt::Debug,
    T: Scalar,
    K: Method,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("KahanAt").field("map", &self.map).field("eps", &self.eps).finish_non_exhaustive()
    }
}
