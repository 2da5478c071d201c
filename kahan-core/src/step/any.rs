//! The common interface of all maps with a fixed ε.
//!
//! A function over [`Step`] accepts compiled maps, maps read at run time, chains and compositions,
//! as a type or as `&dyn Step`.

#[cfg(feature = "std")]
use std::any::Any;
#[cfg(feature = "std")]
use std::boxed::Box;
#[cfg(feature = "std")]
use std::vec::Vec;

use core::array::from_fn;
use core::fmt;

use nalgebra::{ArrayStorage, SMatrix, SVector};

use crate::field::linear::vector;
use crate::{Scalar, SingularStep};

/// A map at its ε, half the time step: x ↦ x̃ on states of [`dimension`](Self::dimension) numbers.
///
/// | map | made by | states |
/// |---|---|---|
/// | of a block of [`kahan!`](crate::kahan) | [`KahanMap::at`](crate::KahanMap::at) | `SVector` |
/// | a composition of such a map | [`KahanAt::composed`](crate::KahanAt::composed) | `SVector` |
/// | of a family, a chain of sites | [`LatticeMap::at`](crate::LatticeMap::at) | `Vec` |
/// | of a text read at run time | `kahan_runtime::Map::at`, `Lattice::at` | `Vec` |
/// | with compensated rounding, except chains | [`Increments::compensated`] | `SMatrix`, `Vec` |
/// | a map with tangent vectors | [`Tangent`](crate::Tangent) | `Vec` |
/// | of a text, with derivatives | `kahan_runtime::MapAt::sensitivities` | `Vec` |
/// | a map over `f64`, on states in `f32` | [`ThroughF64::of_step`] | `Vec` |
/// | a reference to any | `&map` | the map's |
/// | any map, chosen at run time | `&dyn Step<Scalar = f64>`, or in a `Box` | `Vec` |
///
/// [`Increments::compensated`]: crate::Increments::compensated
/// [`ThroughF64::of_step`]: crate::ThroughF64::of_step
///
/// [`state`](Self::state) creates a state from the numbers of a point.
/// [`Orbit::new`](crate::Orbit::new) and [`first_crossing`](crate::observe::first_crossing) accept
/// any map. Chains have no compositions, no compensation and no tangent vectors.
///
/// Results equal those of the map's own methods bit for bit. A state of another length panics. For
/// a chain write `Step::advance(&chain, …)`, because a chain has its own method `advance`.
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_core::{Composition, Step};
///
/// kahan! {
///     /// Predator and prey.
///     pub struct LotkaVolterra;
///     xdot = x*(1 - y);
///     ydot = y*(x - 1);
/// }
///
/// /// The most that a state's first entry is on the way.
/// fn crest(map: &dyn Step<Scalar = f64>, start: &[f64]) -> f64 {
///     let mut x = start.to_vec();
///     (0..1000).fold(x[0], |most, _| {
///         map.run(&mut x, 1).expect("floats go on at poles");
///         most.max(x[0])
///     })
/// }
///
/// let plain = LotkaVolterra.at(0.05);
/// let composed = plain.composed(Composition::KAHAN_LI_8);
/// let choice: [&dyn Step<Scalar = f64>; 2] = [&plain, &composed];
/// let crests = choice.map(|map| crest(map, &[0.5, 1.0]));
/// assert!((crests[0] - crests[1]).abs() < 1e-2 && crests[0] != crests[1]);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no map at an ε",
    label = "not a prepared map, nor a reference to one",
    note = "`map.at(eps)` prepares a map; one that is chosen at run time is a `&dyn Step<Scalar = f64>`"
)]
pub trait Step {
    /// The type of the numbers in a state.
    type Scalar: Scalar;

    /// The type of states, an array if the number of variables is known at compile time.
    type State: StateVector<Self::Scalar>
    where
        Self: Sized;

    /// Returns the number of entries in a state.
    fn dimension(&self) -> usize;

    /// Returns ε, half the time step.
    fn eps(&self) -> &Self::Scalar;

    /// Replaces `x` by the state after `steps` steps.
    ///
    /// Each call creates a workspace. [`advance`](Self::advance) gets one from the caller instead.
    ///
    /// # Errors
    /// Returns the errors of [`advance`](Self::advance).
    /// # Panics
    /// Panics as [`advance`](Self::advance) does.
    fn run(&self, x: &mut [Self::Scalar], steps: u64) -> Result<(), Stopped> {
        self.advance(x, steps, &mut Workspace::new())
    }

    /// Replaces `x` by the state after one step at `eps` instead of the map's ε.
    ///
    /// Each call creates a workspace. [`part`](Self::part) takes one from the caller instead.
    ///
    /// # Errors
    /// Returns the errors of [`advance`](Self::advance).
    /// # Panics
    /// Panics as [`advance`](Self::advance) does.
    fn run_part(&self, eps: &Self::Scalar, x: &mut [Self::Scalar]) -> Result<(), Stopped> {
        self.part(eps, x, &mut Workspace::new())
    }

    /// Replaces `x` by the state after `steps` steps, using `workspace` as scratch memory.
    ///
    /// A call may allocate once, in `workspace`. Over floats, the steps themselves do not allocate.
    ///
    /// # Errors
    /// Returns [`Stopped`] at a pole of an exact scalar, and leaves the pole in `x`. Floats
    /// continue at poles.
    ///
    /// # Panics
    /// If the length of `x` is not [`dimension`](Self::dimension).
    fn advance(&self, x: &mut [Self::Scalar], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped>;

    /// Replaces `x` by the state after one step at `eps`, for which the step is prepared anew.
    ///
    /// For 0 ≤ θ ≤ 1, the states after steps at θε form a curve from x to x̃ with the accuracy of a
    /// step.
    ///
    /// # Errors
    /// Returns the errors of [`advance`](Self::advance).
    /// # Panics
    /// Panics as [`advance`](Self::advance) does.
    fn part(
        &self,
        eps: &Self::Scalar,
        x: &mut [Self::Scalar],
        workspace: &mut Workspace,
    ) -> Result<(), Stopped>;

    /// Returns the state that consists of `point`, followed by zeros.
    ///
    /// # Panics
    /// If `point` is longer than a state.
    fn state(&self, point: &[Self::Scalar]) -> Self::State
    where
        Self: Sized,
    {
        let mut state = Self::State::zeros(self.dimension());
        state.as_mut_slice()[..point.len()].clone_from_slice(point);
        state
    }

    /// Returns the next state x̃, or `None` at a pole of an exact scalar.
    #[inline]
    fn next(&self, x: &Self::State, workspace: &mut Workspace) -> Option<Self::State>
    where
        Self: Sized,
    {
        let mut next = x.clone();
        self.advance(next.as_mut_slice(), 1, workspace).ok()?;
        Some(next)
    }
}

/// The points of a map's orbits: states without the numbers that are stored beside the point.
pub type PointOf<S> = <<S as Step>::State as StateVector<<S as Step>::Scalar>>::Point;

/// Takes `steps` steps by calls of `next`, on a local state that compilers keep in registers.
#[inline(never)]
pub(crate) fn advance_by<T: Scalar, V: StateVector<T>>(
    x: &mut [T],
    steps: u64,
    eps: &T,
    mut next: impl FnMut(&V) -> Option<V>,
) -> Result<(), Stopped> {
    let mut state = V::zeros(x.len());
    state.as_mut_slice().clone_from_slice(x);
    let mut made = 0;
    while made < steps
        && let Some(after) = next(&state)
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

#[track_caller]
#[inline]
pub(crate) fn check_length(found: usize, expected: usize) {
    assert!(found == expected, "a state of {found} numbers for a map of {expected}");
}

/// A state whose numbers form one slice: a point, then for example tangent vectors.
pub trait StateVector<T>: Clone + fmt::Debug {
    /// The type of the point. For a `Vec` the point is the whole state.
    type Point: StateVector<T>;

    /// Returns a state of `len` zeros.
    ///
    /// # Panics
    /// If the type has a fixed length that differs from `len`.
    fn zeros(len: usize) -> Self;

    /// Returns all numbers of the state.
    fn as_slice(&self) -> &[T];

    /// Returns all numbers of the state, mutably.
    fn as_mut_slice(&mut self) -> &mut [T];

    /// Returns the numbers of the point.
    fn point(&self) -> &[T];

    /// Returns a copy of the point.
    fn to_point(&self) -> Self::Point;

    /// Replaces the state by the next state. Returns `None` at a pole of an exact scalar.
    fn step_with<S>(&mut self, map: &S, workspace: &mut Workspace) -> Option<()>
    where
        S: Step<Scalar = T, State = Self>,
        T: Scalar;
}

/// A state stored as columns, of which the first is the point.
impl<T: Scalar, const N: usize, const C: usize> StateVector<T> for SMatrix<T, N, C> {
    type Point = SVector<T, N>;

    #[inline]
    fn zeros(len: usize) -> Self {
        check_length(len, N * C);
        SMatrix::from_array_storage(ArrayStorage(from_fn(|_| from_fn(|_| T::zero()))))
    }

    #[inline]
    fn as_slice(&self) -> &[T] {
        self.data.as_slice()
    }

    #[inline]
    fn as_mut_slice(&mut self) -> &mut [T] {
        self.data.as_mut_slice()
    }

    #[inline(always)]
    fn point(&self) -> &[T] {
        &self.data.0[0]
    }

    #[inline(always)]
    fn to_point(&self) -> SVector<T, N> {
        vector(self.data.0[0].clone())
    }

    #[inline(always)]
    fn step_with<S: Step<Scalar = T, State = Self>>(
        &mut self,
        map: &S,
        workspace: &mut Workspace,
    ) -> Option<()> {
        *self = map.next(self, workspace)?;
        Some(())
    }
}

#[cfg(feature = "std")]
impl<T: Scalar> StateVector<T> for Vec<T> {
    type Point = Self;

    fn zeros(len: usize) -> Self {
        std::vec![T::zero(); len]
    }

    fn as_slice(&self) -> &[T] {
        self
    }

    fn as_mut_slice(&mut self) -> &mut [T] {
        self
    }

    fn point(&self) -> &[T] {
        self
    }

    fn to_point(&self) -> Self {
        self.clone()
    }

    fn step_with<S: Step<Scalar = T, State = Self>>(
        &mut self,
        map: &S,
        workspace: &mut Workspace,
    ) -> Option<()> {
        map.advance(self, 1, workspace).ok()
    }
}

/// Reusable scratch memory. The contents never influence results, and therefore one workspace can
/// serve different maps.
#[derive(Default)]
pub struct Workspace {
    #[cfg(feature = "std")]
    held: Option<Box<dyn Any + Send + Sync>>,
}

impl Workspace {
    /// Returns an empty workspace.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Returns the stored memory if it has type `M` and `fits` accepts it, otherwise memory from
    /// `make`.
    #[cfg(feature = "std")]
    pub fn of<M: Any + Send + Sync>(
        &mut self,
        fits: impl FnOnce(&M) -> bool,
        make: impl FnOnce() -> M,
    ) -> &mut M {
        let is_held = self.held.as_ref().and_then(|held| held.downcast_ref()).is_some_and(fits);
        if !is_held {
            self.held = Some(Box::new(make()));
        }
        let held = self.held.as_mut().and_then(|held| held.downcast_mut());
        held.unwrap_or_else(|| unreachable!("it is of this type"))
    }
}

impl Clone for Workspace {
    fn clone(&self) -> Self {
        Self::new()
    }
}

impl fmt::Debug for Workspace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Workspace").finish_non_exhaustive()
    }
}

/// The report on a run that stopped before its last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stopped {
    /// The number of steps taken before the failure.
    pub steps: u64,
    /// The reason why the next step failed.
    pub why: SingularStep,
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "after {} steps: {}", self.steps, self.why)
    }
}

impl core::error::Error for Stopped {}

impl<S: Step> Step for &S {
    type Scalar = S::Scalar;
    type State = S::State;

    fn dimension(&self) -> usize {
        S::dimension(self)
    }

    fn eps(&self) -> &S::Scalar {
        S::eps(self)
    }

    fn advance(&self, x: &mut [S::Scalar], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        S::advance(self, x, steps, workspace)
    }

    fn part(&self, eps: &S::Scalar, x: &mut [S::Scalar], workspace: &mut Workspace) -> Result<(), Stopped> {
        S::part(self, eps, x, workspace)
    }

    #[inline]
    fn next(&self, x: &S::State, workspace: &mut Workspace) -> Option<S::State> {
        S::next(self, x, workspace)
    }
}

#[cfg(feature = "std")]
macro_rules! implement_for_a_choice {
    ($($choice:ty),*) => {$(
        impl<T: Scalar> Step for $choice {
            type Scalar = T;
            type State = Vec<T>;

            fn dimension(&self) -> usize {
                (**self).dimension()
            }

            fn eps(&self) -> &T {
                (**self).eps()
            }

            fn advance(&self, x: &mut [T], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
                (**self).advance(x, steps, workspace)
            }

            fn part(&self, eps: &T, x: &mut [T], workspace: &mut Workspace) -> Result<(), Stopped> {
                (**self).part(eps, x, workspace)
            }
        }
    )*};
}

#[cfg(feature = "std")]
implement_for_a_choice!(&(dyn Step<Scalar = T> + '_), Box<dyn Step<Scalar = T> + '_>);
