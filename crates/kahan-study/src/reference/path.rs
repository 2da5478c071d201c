//! The Taylor method: the flow as power series in time, continued from point to point.

use core::fmt;

use kahan_core::nalgebra::SVector;
use kahan_core::{Dd, KahanMap};
use kahan_dynamics::{Flow, NoFlow};

use super::no_reference::NoReference;

const MOST_MEMORY: usize = 1 << 30;

/// Limits on the computation of a trajectory.
#[derive(Clone, Copy, Default)]
pub struct TrajectoryLimits<'a> {
    /// The trajectory is computed beyond [`Trajectory::end`](super::Trajectory::end) by this
    /// fraction of `end`, because the last step of an orbit may lie there.
    pub margin: f64,
    /// Errors and scale are measured in the first coordinates, this many of them; in all if `None`.
    pub variables: Option<usize>,
    /// A function that returns whether the time is over; `None` for no limit.
    pub is_over: Option<&'a dyn Fn() -> bool>,
}

impl TrajectoryLimits<'_> {
    pub(super) fn is_over(&self) -> bool {
        self.is_over.is_some_and(|is_over| is_over())
    }
}

impl fmt::Debug for TrajectoryLimits<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Limits").field("margin", &self.margin).finish_non_exhaustive()
    }
}

pub(super) fn path<M, const N: usize>(
    map: &M,
    start: SVector<Dd, N>,
    end: f64,
    limits: &TrajectoryLimits<'_>,
) -> Result<Flow<Dd>, NoReference>
where
    M: KahanMap<Dd, N>,
{
    let piece = (Flow::<Dd>::DEGREE + 1) * N * size_of::<Dd>();
    let go_on = &mut |pieces| pieces < MOST_MEMORY / piece && !limits.is_over();
    let flow = Flow::through(map, start, end, limits.margin, go_on).map_err(|why| match why {
        NoFlow::Escapes { time } => NoReference::Escapes { time },
        NoFlow::Stopped { reached } if limits.is_over() => NoReference::NoTime { reached },
        NoFlow::Stopped { reached } => NoReference::TooLong { reached },
    })?;
    Ok(match limits.variables {
        Some(variables) => flow.of_first(variables, end),
        None => flow,
    })
}
