//! Steps at fixed ε and parameters: written by the macro, run by orbits, maps and ensembles.
//!
//! In: constants computed once. Out: for each state the increment x̃ − x, as numerators and the
//! reciprocals of their denominators ([`Quotients`]).

mod any;
mod cost;
pub(crate) mod error;
mod quotients;
mod straight;
mod two_forms;

use nalgebra::SVector;

use crate::Scalar;

pub use any::{PointOf, StateVector, Step, Stopped, Workspace};
pub(crate) use any::{advance_by, check_length};
pub use cost::StepCost;
pub use error::{Reason, SingularStep};
pub use quotients::Quotients;
pub use straight::{Kernel, Padded, StraightStep};
pub use two_forms::{StepOfOneOrbit, StepOverEps};

/// A step at fixed ε and parameters.
///
/// Steps by hand implement only [`quotients`](Self::quotients), with `Wide` = [`NoLanes`]. Only
/// operations of the scalar allocate, and their order is fixed.
pub trait PreparedStep<T: Scalar, const N: usize>: Clone {
    /// The cost of one step; the default is elimination in N variables.
    const COST: StepCost = StepCost::of_elimination(N);

    /// Whether lanes can run the step: true for straight-line code, false for elimination.
    const HAS_LANES: bool = false;

    /// The step over another scalar, such as a register of lanes; [`NoLanes`] without lanes.
    type Wide<L: Scalar>: PreparedStep<L, N>;

    /// Returns the increment before its last multiplication; `None` at a pole of an exact scalar.
    ///
    /// Implementations are `#[inline(always)]`, because lanes must be compiled into the function
    /// that enables their instructions.
    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>>;

    /// Hands the increment at `x` to `finish`, in the branch of each form of the step.
    #[inline(always)]
    fn finish<R>(&self, x: &SVector<T, N>, finish: impl FnOnce(Quotients<T, N>) -> R) -> Option<R> {
        Some(finish(self.quotients(x)?))
    }

    /// Returns x̃ − x.
    #[inline]
    fn increment(&self, x: &SVector<T, N>) -> Option<SVector<T, N>> {
        self.finish(x, |quotients| quotients.increment())
    }

    /// Returns x̃; the last multiplication and addition are fused if the scalar can.
    #[inline(always)]
    fn next(&self, x: &SVector<T, N>) -> Option<SVector<T, N>> {
        self.finish(x, |quotients| quotients.added_to(x))
    }

    /// Returns x̃ and its carry from x and its carry: the step of a compensated orbit.
    #[inline(always)]
    fn next_with_carry(&self, x: &SVector<T, N>, carry: &SVector<T, N>) -> Option<[SVector<T, N>; 2]> {
        self.finish(x, |quotients| quotients.added_with_carry(x, carry))
    }

    /// Returns the step over `L`, with each constant spread over all lanes.
    ///
    /// # Panics
    /// If `HAS_LANES` is false.
    fn widen<L: Scalar>(&self, _spread: impl Fn(&T) -> L) -> Self::Wide<L> {
        panic!("a step that chooses has no lanes: step each state alone")
    }

    /// Returns the step over `L` that runs the steps of W lanes; `pack` combines their constants.
    ///
    /// # Panics
    /// If `HAS_LANES` is false.
    fn gather<L: Scalar, const W: usize>(_each: [&Self; W], _pack: impl Fn([&T; W]) -> L) -> Self::Wide<L> {
        panic!("a step that chooses has no lanes: step each state alone")
    }
}

/// The wide step of a step without lanes, which has no values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoLanes {}

impl<L: Scalar, const N: usize> PreparedStep<L, N> for NoLanes {
    type Wide<W: Scalar> = Self;

    fn quotients(&self, _x: &SVector<L, N>) -> Option<Quotients<L, N>> {
        match *self {}
    }
}
