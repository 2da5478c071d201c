//! The loop that all ensembles run: tiles, steps, groups.
//!
//! In: columns and a step over one kind of register. Out: the columns some steps later. A tile
//! stays in the nearest cache while all of its steps run. Each stage of a step is one pass over the
//! tile: its groups do not depend on each other, so the processor itself overlaps their long chains
//! of operations. Registers hold no more than one group; holding several gains nothing measurable.

use core::array::from_fn;

use crate::composition::Staged;
use crate::field::linear::vector;
use crate::{PreparedStep, Scalar};

use super::columns::{GROUP, Group};
use super::lanes::Lanes;

/// Advances every column by `steps`, each of them all `stages` in order; `None` at a pole of a
/// scalar that has no reciprocal of zero, with some trajectories advanced and others not.
///
/// Inlined into its caller, whose instructions it then is compiled with.
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
        // Slices of one length in sight of the loop, so that it checks no index.
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

/// The length of a tile: at most 512 trajectories and 16 KiB, half of the smallest nearest cache in
/// use, but at least one group.
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
