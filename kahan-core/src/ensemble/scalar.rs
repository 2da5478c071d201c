//! The scalars of ensembles, with the loops that advance columns.

#![expect(private_bounds, reason = "the stages of a step are nobody else's")]

use crate::Scalar;
use crate::composition::Staged;
use crate::{KahanMap, PreparedStep};

use super::columns::Group;
use super::lanes::{InLanes, LaneSweep, OverLanes};
use super::level::{Instructions, Level};
use super::sweep::sweep;

/// A scalar whose points form an [`Ensemble`](crate::Ensemble).
///
/// The scalars `f32` and `f64` run in SIMD lanes. Any other `Copy` scalar S needs only an empty
/// `impl EnsembleScalar for S {}`, and its trajectories are stepped one at a time.
#[diagnostic::on_unimplemented(
    message = "an ensemble of `{Self}` cannot be advanced",
    label = "not an `EnsembleScalar`; for a number, write `1.0`, not `1`",
    note = "`f32` and `f64` are, and every scalar that is `Copy` becomes one by `impl EnsembleScalar for … {{}}`"
)]
pub trait EnsembleScalar: Scalar + Copy + Send + Sync {
    /// Advances columns of equal length. Returns `None` if a trajectory meets a pole and 1/0 has no
    /// value in this type.
    #[doc(hidden)]
    fn sweep<S, const N: usize>(
        map: &S,
        columns: [&mut [Group<Self>]; N],
        steps: u64,
        _instructions: Instructions,
    ) -> Option<()>
    where
        S: Staged<Self, N>,
    {
        sweep::<Self, S, _, _, N>(&map.stages(|at| at.prepared.clone()), columns, steps)
    }

    /// Runs `work` with the instruction set `level`. Returns `None` if the scalar has no lanes.
    #[doc(hidden)]
    fn over_lanes<W: OverLanes<Self>>(_work: W, _level: Level) -> Option<W::Output> {
        None
    }
}

macro_rules! implement_for_float {
    ($float:ty) => {
        impl EnsembleScalar for $float {
            #[doc(hidden)]
            fn over_lanes<W: OverLanes<Self>>(work: W, level: Level) -> Option<W::Output> {
                Some(<Self as InLanes>::run(work, level))
            }

            #[doc(hidden)]
            fn sweep<S, const N: usize>(
                map: &S,
                columns: [&mut [Group<Self>]; N],
                steps: u64,
                instructions: Instructions,
            ) -> Option<()>
            where
                S: Staged<Self, N>,
            {
                if <S::Map as KahanMap<Self, N>>::Prepared::HAS_LANES {
                    <Self as LaneSweep>::advance_lanes(map, columns, steps, instructions)
                } else {
                    sweep::<Self, S, _, _, N>(&map.stages(|at| at.prepared.clone()), columns, steps)
                }
            }
        }
    };
}

implement_for_float!(f32);
implement_for_float!(f64);

impl EnsembleScalar for crate::Dd {}
