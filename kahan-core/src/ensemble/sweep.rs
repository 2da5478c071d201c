//! The loop of ensembles with one map, which runs over tiles, steps, stages and groups.
//!
//! A tile stays in the first-level cache for all its steps, unless a single group exceeds 16 KiB.
//! Each stage of a step is one pass over the tile, in which the processor overlaps the operations
//! of independent groups.

use core::array::from_fn;

use crate::composition::Staged;
use crate::field::linear::vector;
use crate::{PreparedStep, Scalar};

use super::columns::{GROUP, Group};
use super::lanes::Lanes;

/// Advances every column by `steps` steps, each of which runs all `stages` in order. If 1/0 has no
/// value in T, a pole gives `None` and leaves some columns unadvanced.
///
/// The function must be inlined; only then the caller's target features apply.
#[inline(always)]
pub(crate) fn sweep<R, S, T, P, const N: usize>(
    stages: &S::Stages<P>,
    mut columns: [&mut [Group<T>]; N],
    steps: u64,
) -> Option<()>
where
    R: Lanes<T>,
    S: Staged<T, N>,
    T: Scalar,
    P: PreparedStep<R, N>,
{
    let groups = columns.first().map_or(0, |column| column.len());
    for first in (0..groups).step_by(groups_per_tile::<T, N>()) {
        let len = groups_per_tile::<T, N>().min(groups - first);
        // The slices have one known length; therefore the inner loop needs no bounds checks.
        let mut tile = columns.each_mut().map(|column| &mut column[first..][..len]);
        for _ in 0..steps {
            for step in S::in_order(stages) {
                for group in 0..len {
                    for part in 0..GROUP / R::WIDTH {
                        let place = part * R::WIDTH;
                        let x = vector(from_fn(|c| R::load(&tile[c][group], place)));
                        let next = step.next(&x)?;
                        for (c, column) in tile.iter_mut().enumerate() {
                            next[c].store(&mut column[group], place);
                        }
                    }
                }
            }
        }
    }
    Some(())
}

/// Returns the number of groups in a tile, at most 512 trajectories and 16 KiB.
pub(crate) const fn groups_per_tile<T, const N: usize>() -> usize {
    const TRAJECTORIES: usize = 512;
    const BYTES: usize = 16 << 10;

    let most = TRAJECTORIES / GROUP;
    let group = N * size_of::<Group<T>>();
    if group == 0 || BYTES / group > most {
        most
    } else if BYTES / group == 0 {
        1
    } else {
        BYTES / group
    }
}
