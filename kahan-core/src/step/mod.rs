//! Steps at fixed ε and parameters. The macro generates them; orbits, maps and ensembles run them.
//!
//! A step returns the increment x̃ − x as numerators and reciprocals ([`Quotients`]).

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
/// Handwritten steps implement only [`quotients`](Self::quotients), with `Wide` = [`NoLanes`]. Only
/// operations of the scalar may allocate.
pub trait PreparedStep<T: Scalar, const N: usize>: Clone {
    /// The cost of one step. The default is the cost of elimination in N variables.
    const COST: StepCost = StepCost::of_elimination(N);

    /// Whether SIMD lanes can run the step. Straight-line code can run in lanes, elimination
    /// cannot.
    const HAS_LANES: bool = false;

    /// The step over another scalar, or [`NoLanes`] if lanes cannot run the step.
    type Wide<L: Scalar>: PreparedStep<L, N>;

    /// Returns the increment before its last multiplication, or `None` at a pole of an exact
    /// scalar.
    /// Implementations are `#[inline(always)]`, so that a caller's target features apply to lanes.
    fn quotients(&self, x: &SVector<T, N>) -> Option<Quotients<T, N>>;

    /// Passes the increment at `x` to `finish`.
    #[inline(always)]
    fn finish<R>(&self, x: &SVector<T, N>, finish: impl FnOnce(Quotients<T, N>) -> R) -> Option<R> {
        Some(finish(self.quotients(x)?))
    }

    /// Returns the increment x̃ − x of a step from x to x̃.
    #[inline]
    fn increment(&self, x: &SVector<T, N>) -> Option<SVector<T, N>> {
        self.finish(x, |quotients| quotients.increment())
    }

    /// Returns the next state x̃.
    #[inline(always)]
    fn next(&self, x: &SVector<T, N>) -> Option<SVector<T, N>> {
        self.finish(x, |quotients| quotients.added_to(x))
    }

    /// Returns the next state x̃ and its carry, the rounding error of a state on a compensated
    /// orbit.
    #[inline(always)]
    fn next_with_carry(&self, x: &SVector<T, N>, carry: &SVector<T, N>) -> Option<[SVector<T, N>; 2]> {
        self.finish(x, |quotients| quotients.added_with_carry(x, carry))
    }

    /// Returns the step over the scalar `L`, with each constant copied to all lanes.
    ///
    /// # Panics
    /// If `HAS_LANES` is false.
    fn widen<L: Scalar>(&self, _spread: impl Fn(&T) -> L) -> Self::Wide<L> {
        panic!("a step that chooses has no lanes: step each state alone")
    }

    /// Returns the step over `L` that runs one of W steps per lane. The function `pack` combines W
    /// constants.
    ///
    /// # Panics
    /// If `HAS_LANES` is false.
    fn gather<L: Scalar, const W: usize>(_each: [&Self; W], _pack: impl Fn([&T; W]) -> L) -> Self::Wide<L> {
        panic!("a step that chooses has no lanes: step each state alone")
    }
}

/// A type without values, used in place of lanes by steps that lanes cannot run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoLanes {}

impl<L: Scalar, const N: usize> PreparedStep<L, N> for NoLanes {
    type Wide<W: Scalar> = Self;

    fn quotients(&self, _x: &SVector<L, N>) -> Option<Quotients<L, N>> {
        match *self {}
    }
}
