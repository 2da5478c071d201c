//! The step of a map whose ε and parameters are known: what the macro writes, and what orbits,
//! prepared maps and ensembles run.
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

/// A step that knows its ε and its parameters.
///
/// By hand, [`quotients`](Self::quotients) is all that is written, and `Wide` is [`NoLanes`].
/// Nothing in a step allocates beyond what the scalar does, and the order of operations is fixed.
pub trait PreparedStep<T: Scalar, const N: usize>: Clone {
    /// What one step costs; here, elimination in N variables.
    const COST: StepCost = StepCost::of_elimination(N);

    /// Whether the step is straight-line code, which lanes run side by side; elimination chooses
    /// its pivots by comparing, so it is none.
    const HAS_LANES: bool = false;

    /// This step over another scalar, such as the lanes of a register; [`NoLanes`] where
    /// `HAS_LANES` is false.
    type Wide<L: Scalar>: PreparedStep<L, N>;

    /// The increment at `x` before its last multiplication, or `None` at a pole of a scalar that
    /// has no reciprocal of zero.
    ///
    /// Implementations are `#[inline(always)]`, because lanes must be compiled into the function
    /// that enables their instructions.
    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>>;

    /// The increment at `x`, handed to `finish`; a step of two forms hands that of each on by
    /// itself.
    #[inline(always)]
    fn finish<R>(&self, x: &SVector<T, N>, finish: impl FnOnce(Quotients<T, N>) -> R) -> Option<R> {
        Some(finish(self.quotients(x)?))
    }

    /// x̃ − x.
    #[inline]
    fn increment(&self, x: &SVector<T, N>) -> Option<SVector<T, N>> {
        self.finish(x, |quotients| quotients.increment())
    }

    /// x̃, the last multiplication and addition fused where the scalar can.
    #[inline(always)]
    fn next(&self, x: &SVector<T, N>) -> Option<SVector<T, N>> {
        self.finish(x, |quotients| quotients.added_to(x))
    }

    /// x̃ and what it lacks, from x and what x lacks: the step of a compensated orbit.
    #[inline(always)]
    fn next_with_carry(&self, x: &SVector<T, N>, carry: &SVector<T, N>) -> Option<[SVector<T, N>; 2]> {
        self.finish(x, |quotients| quotients.added_with_carry(x, carry))
    }

    /// Each constant spread over the lanes of `L`.
    ///
    /// # Panics
    /// Where `HAS_LANES` is false.
    fn widen<L: Scalar>(&self, _spread: impl Fn(&T) -> L) -> Self::Wide<L> {
        panic!("a step that chooses has no lanes: step each state alone")
    }

    /// The steps of W lanes as one: each constant of it is what `pack` makes of those of the lanes.
    ///
    /// # Panics
    /// Where `HAS_LANES` is false.
    fn gather<L: Scalar, const W: usize>(_each: [&Self; W], _pack: impl Fn([&T; W]) -> L) -> Self::Wide<L> {
        panic!("a step that chooses has no lanes: step each state alone")
    }
}

/// The wide step of a step without lanes: there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoLanes {}

impl<L: Scalar, const N: usize> PreparedStep<L, N> for NoLanes {
    type Wide<W: Scalar> = Self;

    fn quotients(&self, _x: &SVector<L, N>) -> Option<Quotients<L, N>> {
        match *self {}
    }
}
