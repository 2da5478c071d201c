//! What every map at its ε can do, whatever it was made of.
//!
//! In: a state as a slice. Out: the state some steps later, in its place. A function over
//! [`Step`] takes a compiled map, one that is read at run time, a chain, a composition, by its type
//! or as `&dyn Step`.

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
/// | a composition of that | [`KahanAt::composed`](crate::KahanAt::composed) | `SVector` |
/// | of a family, a chain of some sites | [`LatticeMap::at`](crate::LatticeMap::at) | `Vec` |
/// | of a text that is read at run time | `kahan_runtime::Map::at`, `Lattice::at` | `Vec` |
/// | one of these or of a text, rounding errors beside its points | [`Increments::compensated`](crate::Increments::compensated) | `SMatrix` of two columns, `Vec` |
/// | the same with tangent vectors beside its points | [`Tangent`](crate::Tangent) | `Vec` |
/// | of a text, derivatives by first points, parameters and ε beside its points | `kahan_runtime::MapAt::sensitivities` | `Vec` |
/// | any map over `f64`, on states in `f32` | [`ThroughF64::of_step`](crate::ThroughF64::of_step) | `Vec` |
/// | a reference to any | `&map` | the map's |
/// | any, chosen at run time | `&dyn Step<Scalar = f64>`, `Box<dyn Step<Scalar = f64>>` | `Vec` |
///
/// [`state`](Self::state) makes a state of the numbers of a point, whatever the map carries beside
/// it; [`Orbit::new`](crate::Orbit::new) and [`first_crossing`](crate::observe::first_crossing)
/// take any map. A chain has no compositions, and carries neither rounding errors nor vectors.
///
/// Bits are those of the map's own methods. A state of another length panics, as dimensions of
/// nalgebra do. A chain has an `advance` of its own, in memory of its own, which
/// `chain.advance(&mut x, steps)` calls; for that of this trait write `Step::advance(&chain, …)`.
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
    /// The numbers that a state is made of.
    type Scalar: Scalar;

    /// A state: an array where the number of variables is known while compiling.
    type State: StateVector<Self::Scalar>
    where
        Self: Sized;

    /// How many numbers a state has.
    fn dimension(&self) -> usize;

    /// ε, half the time step.
    fn eps(&self) -> &Self::Scalar;

    /// Replaces `x` by the state after `steps` steps.
    ///
    /// Each call makes a workspace; [`advance`](Self::advance) takes one from its caller.
    ///
    /// # Errors
    /// # Panics
    /// As [`advance`](Self::advance).
    fn run(&self, x: &mut [Self::Scalar], steps: u64) -> Result<(), Stopped> {
        self.advance(x, steps, &mut Workspace::new())
    }

    /// Replaces `x` by the state after one step at another ε.
    ///
    /// Each call makes a workspace; [`part`](Self::part) takes one from its caller.
    ///
    /// # Errors
    /// # Panics
    /// As [`advance`](Self::advance).
    fn run_part(&self, eps: &Self::Scalar, x: &mut [Self::Scalar]) -> Result<(), Stopped> {
        self.part(eps, x, &mut Workspace::new())
    }

    /// Replaces `x` by the state after `steps` steps, and computes in `workspace`.
    ///
    /// Loops share one workspace among their calls; [`run`](Self::run) needs none.
    ///
    /// Its steps do not allocate. A call may, once: a chain where it finds no memory of its own in
    /// the workspace, and what wraps a map whose states are vectors.
    ///
    /// # Errors
    /// [`Stopped`] at a pole of an exact scalar; `x` is the point there. Floats go on with numbers
    /// that are not finite.
    ///
    /// # Panics
    /// If `x` has not [`dimension`](Self::dimension) numbers.
    fn advance(&self, x: &mut [Self::Scalar], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped>;

    /// One step at another ε: x(θ) = φ_{θε}(x) is the curve from x to x̃, which is as far from the
    /// flow as a step is.
    ///
    /// Cost: what ε fixes is computed anew.
    ///
    /// # Errors
    /// # Panics
    /// As [`advance`](Self::advance).
    fn part(
        &self,
        eps: &Self::Scalar,
        x: &mut [Self::Scalar],
        workspace: &mut Workspace,
    ) -> Result<(), Stopped>;

    /// The state at a point; what the map carries beside it is 0.
    ///
    /// # Panics
    /// If there are more numbers than a state has.
    fn state(&self, point: &[Self::Scalar]) -> Self::State
    where
        Self: Sized,
    {
        let mut state = Self::State::zeros(self.dimension());
        state.as_mut_slice()[..point.len()].clone_from_slice(point);
        state
    }

    /// x̃; `None` at a pole of an exact scalar.
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

/// What an orbit of a map yields: a state without what is carried beside its point.
pub type PointOf<S> = <<S as Step>::State as StateVector<<S as Step>::Scalar>>::Point;

/// [`Step::advance`] by a step of states that need no memory: the loop has a state of its own,
/// which compilers keep in registers.
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

/// Sees that a state has the numbers that a map takes.
#[track_caller]
#[inline]
pub(crate) fn check_length(found: usize, expected: usize) {
    assert!(found == expected, "a state of {found} numbers for a map of {expected}");
}

/// A state as numbers one after the other: those of a point, and behind them what a mode carries
/// beside it.
pub trait StateVector<T>: Clone + fmt::Debug {
    /// The point alone. A `Vec` does not tell it from what is carried: there it is all numbers.
    type Point: StateVector<T>;

    /// So many zeros.
    ///
    /// # Panics
    /// If it has another length.
    fn zeros(len: usize) -> Self;

    /// Its numbers.
    fn as_slice(&self) -> &[T];

    /// Its numbers, to be changed.
    fn as_mut_slice(&mut self) -> &mut [T];

    /// The numbers of the point.
    fn point(&self) -> &[T];

    /// A copy of the point.
    fn to_point(&self) -> Self::Point;

    /// Replaces it by the state one step of a map later: arrays by [`Step::next`], so that they
    /// stay in registers, vectors by [`Step::advance`], which allocates none. `None` at a pole of
    /// an exact scalar.
    fn step_with<S>(&mut self, map: &S, workspace: &mut Workspace) -> Option<()>
    where
        S: Step<Scalar = T, State = Self>,
        T: Scalar;
}

/// The first column is the point.
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

/// Memory to compute in, which a map takes when it first needs some. One serves any maps in turn,
/// and a map's results do not depend on what is in it.
#[derive(Default)]
pub struct Workspace {
    #[cfg(feature = "std")]
    held: Option<Box<dyn Any + Send + Sync>>,
}

impl Workspace {
    /// An empty one.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// What a map keeps here: what is held, if it is of this type and `fits`, or else what `make`
    /// makes.
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

/// An empty one: what is held is no value.
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

/// Where a run ended before it was done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stopped {
    /// The steps made.
    pub steps: u64,
    /// Why there is no other.
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

/// One that is chosen at run time: its states are vectors.
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
