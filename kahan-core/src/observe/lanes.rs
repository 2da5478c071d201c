//! Tangent vectors of a group of trajectories, side by side in registers.
//!
//! In: the points of the group, and its vectors as columns. Out: the vectors carried along, and the
//! squares of their lengths at every step. The operations are those of one trajectory alone, in the
//! same order and never fused, so the bits are the same on every level.

use core::array::from_fn;

use crate::ensemble::columns::{GROUP, Group};
use crate::ensemble::lanes::{Lanes, OverLanes};
use crate::field::linear::vector;
use crate::map::{TangentStep, carry, tangent_stages};
use crate::{EnsembleScalar, Level, Lift, Method, PreparedStep, Scalar, TangentAt};

use super::Grouped;
use super::growth::most;

/// Vectors that are carried from points to the next ones.
struct SideBySide<'a, M: Lift<T, N>, T: Scalar, K: Method, P, const N: usize> {
    tangent: &'a TangentAt<M, T, N, K>,
    places: &'a [P],
    vectors: &'a mut [P],
    /// The squares of their lengths after each step.
    squares: &'a mut [Group<T>],
}

/// Carries vectors, each N columns, along the points at `places`, until the square of one leaves the
/// range that vectors are kept in: the steps taken. `None` where the step, or the scalar, has no
/// lanes.
pub(super) fn carry_side_by_side<M, T, K, P, const N: usize>(
    tangent: &TangentAt<M, T, N, K>,
    places: &[P],
    vectors: &mut [P],
    squares: &mut [Group<T>],
    level: Level,
) -> Option<usize>
where
    M: Lift<T, N>,
    T: EnsembleScalar,
    K: Method,
    P: Grouped<T>,
{
    let work = SideBySide { tangent, places, vectors, squares };
    if <TangentStep<M, T, N> as PreparedStep<_, N>>::HAS_LANES { T::over_lanes(work, level) } else { None }
}

impl<M, T, K, P, const N: usize> OverLanes<T> for SideBySide<'_, M, T, K, P, N>
where
    M: Lift<T, N>,
    T: EnsembleScalar,
    K: Method,
    P: Grouped<T>,
{
    type Output = usize;
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<T>>(self) -> usize {
        let Self { tangent, places, vectors, squares } = self;
        let stages = tangent_stages::<M, T, K, L, N>(&tangent.map, &tangent.parts, L::spread);
        let (most, least) = (L::spread(&most()), L::spread(&(T::one() / most())));
        let steps = places.iter().zip(squares.chunks_mut(vectors.len()));
        for (step, (place, squares)) in steps.enumerate() {
            let mut is_moderate = true;
            let place = place.as_ref();
            for part in (0..GROUP).step_by(L::WIDTH) {
                let x = vector(from_fn(|i| L::load(&place[i], part)));
                for (columns, squares) in vectors.iter_mut().zip(&mut *squares) {
                    let columns = columns.as_mut();
                    let v = vector(from_fn(|i| L::load(&columns[i], part)));
                    // Floats have a value at every point.
                    let Some(carried) = carry::<K, _, L, N>(&stages, &x, &v) else { continue };
                    let mut squared = L::zero();
                    for (entry, column) in carried.iter().zip(columns) {
                        squared += *entry * *entry;
                        entry.store(column, part);
                    }
                    squared.store(squares, part);
                    is_moderate &= !L::any(squared.exceeds(most)) && !L::any(least.exceeds(squared));
                }
            }
            if !is_moderate {
                return step + 1;
            }
        }
        places.len()
    }
}
