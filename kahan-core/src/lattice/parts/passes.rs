//! The two passes over all groups, on the lanes of a level and on threads.
//!
//! In: a state. Out of the first pass, which only reads it: what each part leaves. Out of the
//! second: the interiors one step later. A group's numbers depend on no other group, so threads
//! change no bit.

use core::marker::PhantomData;
use core::ops::Range;

use crate::ensemble::Level;
use crate::ensemble::lanes::{InLanes, Lanes, OverLanes};
use crate::lattice::{LatticeScalar, Lines, Shape, Sizes};

use super::group::Parts;
use super::joints;
use super::partition::Partition;
use super::scratch::Scratch;

/// Divides groups, and the numbers that belong to them, among threads, each with a scratch of its
/// own; `place` is where a group's numbers begin.
pub(super) fn divide<T: Send>(
    scratch: &mut [Scratch<T>],
    groups: Range<usize>,
    numbers: &mut [T],
    place: &(impl Fn(usize) -> usize + Sync),
    work: &(impl Fn(&mut Scratch<T>, Range<usize>, &mut [T]) + Sync),
) {
    match scratch {
        [] => {}
        [one] => work(one, groups, numbers),
        several => {
            let half = several.len() / 2;
            let middle = groups.start + groups.len() * half / several.len();
            let (these, those) = several.split_at_mut(half);
            let (before, after) = numbers.split_at_mut(place(middle) - place(groups.start));
            join(
                || divide(these, groups.start..middle, before, place, work),
                || divide(those, middle..groups.end, after, place, work),
            );
        }
    }
}

#[cfg(feature = "parallel")]
use rayon::join;

/// Without threads there is one scratch, and nothing to divide.
#[cfg(not(feature = "parallel"))]
fn join(first: impl FnOnce(), second: impl FnOnce()) {
    first();
    second();
}

/// The parts of a group that fit the lanes, batch after batch: each with the number of its first
/// part.
#[inline(always)]
fn batches(partition: &Partition, group: usize, width: usize) -> impl Iterator<Item = (usize, Parts)> {
    let (start, length, lanes) = (partition.start(group), partition.length(group), partition.lanes());
    let parts = move |k| (group * lanes + k, Parts { start: start + k * length, length, width });
    (0..lanes).step_by(width).map(parts)
}

/// Whether two sets of so many rows of so many numbers fit sixteen registers, which are all that
/// AVX2 has.
const fn is_small(rows: usize, numbers: usize) -> bool {
    2 * rows * numbers <= 16
}

/// The unknowns of a separator.
const fn separator<S: Shape>() -> usize {
    S::REACH * S::BLOCK
}

/// Takes chains of some sizes through both passes: one kernel, or the one of a menu that fits.
pub(in crate::lattice) trait Kernels {
    /// Whether there is a kernel of these sizes.
    fn have(sizes: Sizes) -> bool;

    /// The first pass, on the lanes of a level.
    fn first<M, T>(pass: First<'_, M, T>, level: Level)
    where
        M: Lines<T>,
        T: LatticeScalar + InLanes + Copy;

    /// The second pass.
    fn second<M, T>(pass: Second<'_, M, T>, level: Level)
    where
        M: Lines<T>,
        T: LatticeScalar + InLanes + Copy;
}

/// A family's type has its sizes.
impl<S: Shape> Kernels for S {
    fn have(_: Sizes) -> bool {
        true
    }

    fn first<M, T>(pass: First<'_, M, T>, level: Level)
    where
        M: Lines<T>,
        T: LatticeScalar + InLanes + Copy,
    {
        T::run(By::<S, _>(pass, PhantomData), level);
    }

    fn second<M, T>(pass: Second<'_, M, T>, level: Level)
    where
        M: Lines<T>,
        T: LatticeScalar + InLanes + Copy,
    {
        T::run(By::<S, _>(pass, PhantomData), level);
    }
}

/// A pass by the kernel of a shape.
struct By<S, W>(W, PhantomData<S>);

/// What the first pass does to some groups.
pub(in crate::lattice) struct First<'a, M, T> {
    pub(super) partition: &'a Partition,
    pub(super) map: &'a M,
    pub(super) constants: &'a [T],
    pub(super) state: &'a [T],
    pub(super) groups: Range<usize>,
    pub(super) scratch: &'a mut Scratch<T>,
    pub(super) joints: &'a mut [T],
}

impl<S: Shape, M: Lines<T>, T: LatticeScalar + InLanes + Copy> OverLanes<T> for By<S, First<'_, M, T>> {
    type Output = ();
    /// The rows of the window, and those of the separator.
    const IS_SMALL: bool = is_small(S::LOWER + separator::<S>(), S::LOWER + S::UPPER + 1 + separator::<S>());

    #[inline(always)]
    fn run<L: Lanes<T>>(self) {
        let First { partition, map, constants, state, groups, scratch, joints } = self.0;
        let separator = separator::<S>();
        let columns = S::LOWER + 2 * separator + 1;
        let mut joints = joints.chunks_exact_mut(joints::size(separator));
        for group in groups {
            for (_, parts) in batches(partition, group, L::WIDTH) {
                parts.gather(map, state, scratch.x.entries(), scratch.c.entries(), scratch.level);
                S::contribute::<M, L, T>(map, constants, parts.length - S::REACH, scratch);
                let dense = scratch.dense.entries();
                for (lane, joint) in joints.by_ref().take(L::WIDTH).enumerate() {
                    let from = |row: usize, column: usize| dense[(row * columns + column) * L::WIDTH + lane];
                    for row in 0..2 * separator {
                        for column in 0..2 * separator + 1 {
                            joint[row * (2 * separator + 1) + column] =
                                from(S::LOWER + row, S::LOWER + column);
                        }
                    }
                    joint[joints::size(separator) - 1] = from(S::LOWER + 2 * separator, 0);
                }
            }
        }
    }
}

/// What the second does.
pub(in crate::lattice) struct Second<'a, M, T> {
    pub(super) partition: &'a Partition,
    pub(super) map: &'a M,
    pub(super) constants: &'a [T],
    pub(super) twice: &'a T,
    /// States of the sites of the reduced system, and what they gain.
    pub(super) kept: &'a [T],
    pub(super) gained: &'a [T],
    pub(super) sites: usize,
    pub(super) groups: Range<usize>,
    pub(super) scratch: &'a mut Scratch<T>,
    /// From the first site of the first group on.
    pub(super) state: &'a mut [T],
}

impl<S: Shape, M: Lines<T>, T: LatticeScalar + InLanes + Copy> OverLanes<T> for By<S, Second<'_, M, T>> {
    type Output = ();
    /// The rows of the window, which know nothing of the separator.
    const IS_SMALL: bool = is_small(S::LOWER, S::LOWER + S::UPPER + 1);

    #[inline(always)]
    fn run<L: Lanes<T>>(self) {
        let Second { partition, map, constants, twice, kept, gained, sites, groups, scratch, state } = self.0;
        let (block, reach) = (S::BLOCK, S::REACH);
        let separator = reach * block;
        let first = partition.start(groups.start);
        for group in groups {
            for (part, parts) in batches(partition, group, L::WIDTH) {
                parts.gather_parameters(map, sites, scratch.c.entries(), scratch.level);
                let here = Parts { start: parts.start - first, ..parts };
                let x = scratch.x.entries();
                let inner = &mut x[separator * L::WIDTH..];
                here.gather_inner(state, block, 1, parts.length, inner, scratch.level);
                for lane in 0..L::WIDTH {
                    let separators = (part + lane) * separator;
                    for k in 0..separator {
                        // The separator to the right may lie in another thread's numbers.
                        x[(parts.length * block + separator + k) * L::WIDTH + lane] =
                            kept[separators + separator + k];
                    }
                    let known = scratch.known.entries();
                    for k in 0..2 * separator {
                        known[k * L::WIDTH + lane] = gained[separators + k];
                    }
                }
                S::substitute::<M, L, T>(map, constants, twice, parts.length - reach, scratch);
                let x = scratch.x.entries();
                here.scatter_inner(state, block, reach, &x[2 * separator * L::WIDTH..], scratch.level);
            }
        }
    }
}
