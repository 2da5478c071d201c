//! The kernels of both passes for the sizes of a family, and the division of groups among threads.
//!
//! Groups are independent, and therefore the number of threads changes no bits.

use core::marker::PhantomData;
use core::ops::Range;

use crate::ensemble::Level;
use crate::ensemble::lanes::InLanes;
use crate::lattice::{LatticeMap, LatticeScalar, Sizes, Stencil};

use super::first_pass::FirstPass;
use super::group::PartGroup;
use super::partition::Partition;
use super::scratch::Scratch;
use super::second_pass::SecondPass;

/// Divides groups among threads. The numbers of group g begin at `numbers[place(g)]`.
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

#[cfg(not(feature = "parallel"))]
fn join(first: impl FnOnce(), second: impl FnOnce()) {
    first();
    second();
}

pub(in crate::lattice) enum Pass<'a, M, T> {
    First(FirstPass<'a, M, T>),
    Second(SecondPass<'a, M, T>),
}

/// The kernels for one stencil, or for a menu of stencils.
pub(in crate::lattice) trait Kernels {
    fn supports(sizes: Sizes) -> bool;

    fn run<M, T>(pass: Pass<'_, M, T>, level: Level)
    where
        M: LatticeMap<T>,
        T: LatticeScalar + InLanes;
}

pub(super) struct KernelCall<S, W>(pub(super) W, PhantomData<S>);

impl<
    const B: usize,
    const R: usize,
    const P: usize,
    const C: usize,
    const LOWER: usize,
    const UPPER: usize,
    const SITES: usize,
    const WIDTH: usize,
> Kernels for Stencil<B, R, P, C, LOWER, UPPER, SITES, WIDTH>
{
    fn supports(_: Sizes) -> bool {
        true
    }

    fn run<M: LatticeMap<T>, T: LatticeScalar + InLanes>(pass: Pass<'_, M, T>, level: Level) {
        match pass {
            Pass::First(first) => T::run(KernelCall::<Self, _>(first, PhantomData), level),
            Pass::Second(second) => T::run(KernelCall::<Self, _>(second, PhantomData), level),
        }
    }
}

/// Yields batches of `width` parts. A batch comes with the index of its first part.
#[inline(always)]
pub(super) fn batches(
    partition: &Partition,
    groups: Range<usize>,
    width: usize,
) -> impl Iterator<Item = (usize, PartGroup)> {
    groups.flat_map(move |group| {
        let (start, length, lanes) = (partition.start(group), partition.length(group), partition.lanes());
        let parts = move |k| (group * lanes + k, PartGroup { start: start + k * length, length, width });
        (0..lanes).step_by(width).map(parts)
    })
}

/// Returns whether `rows` rows of `numbers` numbers fit into 16 AVX2 registers, if each number
/// takes two registers.
pub(super) const fn is_small(rows: usize, numbers: usize) -> bool {
    2 * rows * numbers <= 16
}
