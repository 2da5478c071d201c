//! Steps of a long chain in parts, which are eliminated in SIMD lanes.
//!
//! The first pass eliminates the interiors of the parts, and reduces the rows of the separators
//! between parts to a small banded system. The second pass computes the interiors from the solution
//! of this system. If an entry far exceeds a pivot or a result is not finite, the chain is
//! eliminated as a whole instead.

mod buffer;
mod first_pass;
mod group;
mod kernels;
mod lines;
mod partition;
mod scratch;
mod second_pass;
mod separators;
mod stencil_menu;
mod window;

use std::vec;
use std::vec::Vec;

use crate::ensemble::Level;
use crate::ensemble::lanes::InLanes;

use super::folded::FoldedBand;
use super::sites::Site;
use super::{Boundary, LatticeMap, LatticeScalar, Sizes};

use first_pass::FirstPass;
pub(super) use kernels::Kernels;
use kernels::{Pass, divide};
pub use lines::{Gathered, SiteLine};
pub(super) use partition::Partition;
use scratch::Scratch;
use second_pass::SecondPass;
pub use stencil_menu::StencilMenu;

pub(super) struct PartWorkspace<T> {
    partition: Partition,
    level: Level,
    scratch: Vec<Scratch<T>>,
    /// The results of the first pass for all parts. Each part has [`separators::size`] numbers.
    joints: Vec<T>,
    /// The old states of the separators and of the remaining sites at the end of the chain.
    kept: Vec<T>,
    reduced: FoldedBand<T>,
}

pub(in crate::lattice) trait PartSolver<T>: Sized + Send + Sync + 'static {
    /// The number of parts per group, `None` for scalars without lanes.
    const LANES: Option<usize>;

    /// Allocates a workspace. Returns `None` for scalars without lanes.
    fn new(sizes: Sizes, partition: Partition, boundary: Boundary, level: Level) -> Option<Self>;

    /// Takes one step. If a pivot is too small or a number is not finite, returns `false` and
    /// leaves the state unchanged.
    fn step<M>(&mut self, map: &M, constants: &[T], twice: &T, site: &mut Site<T>, state: &mut [T]) -> bool
    where
        M: LatticeMap<T>,
        T: LatticeScalar;
}

/// A type without values, which replaces the solver for scalars without lanes.
pub(in crate::lattice) enum NoPartSolver {}

impl<T> PartSolver<T> for NoPartSolver {
    const LANES: Option<usize> = None;

    fn new(_: Sizes, _: Partition, _: Boundary, _: Level) -> Option<Self> {
        None
    }

    fn step<M>(&mut self, _: &M, _: &[T], _: &T, _: &mut Site<T>, _: &mut [T]) -> bool
    where
        M: LatticeMap<T>,
        T: LatticeScalar,
    {
        match *self {}
    }
}

impl<T: LatticeScalar + InLanes> PartSolver<T> for PartWorkspace<T> {
    const LANES: Option<usize> = Some(T::MOST);

    fn new(sizes: Sizes, partition: Partition, boundary: Boundary, level: Level) -> Option<Self> {
        let separator = sizes.reach * sizes.block;
        let kept = partition.reduced_sites() * sizes.block;
        #[cfg(feature = "parallel")]
        let threads = rayon::current_num_threads();
        #[cfg(not(feature = "parallel"))]
        let threads = 1;
        Some(Self {
            partition,
            level,
            scratch: (0..threads.min(partition.groups()))
                .map(|_| Scratch::new(sizes, &partition, level))
                .collect(),
            joints: vec![T::zero(); partition.parts() * separators::size(separator)],
            kept: vec![T::zero(); kept],
            reduced: FoldedBand::new(
                kept,
                boundary == Boundary::Periodic,
                2 * separator - 1,
                2 * separator - 1,
            ),
        })
    }

    fn step<M: LatticeMap<T>>(
        &mut self,
        map: &M,
        constants: &[T],
        twice: &T,
        site: &mut Site<T>,
        state: &mut [T],
    ) -> bool {
        let Sizes { block, reach, .. } = map.sizes();
        let Self { partition, level, scratch, joints, kept, reduced } = self;
        let (partition, level) = (&*partition, *level);
        let groups = 0..partition.groups();
        for (place, first, count) in partition.reduced_runs() {
            kept[place * block..][..count * block].copy_from_slice(&state[first * block..][..count * block]);
        }

        let size = partition.lanes() * separators::size(reach * block);
        divide(scratch, groups.clone(), joints, &|group| group * size, &|scratch, groups, joints| {
            let first = FirstPass { partition, map, constants, state, groups, scratch, joints };
            M::Kernels::run(Pass::First(first), level);
        });
        if separators::solve(partition, joints, reduced, map, constants, site, state).is_none() {
            return false;
        }

        let (kept, gained, sites) = (&**kept, reduced.solution(), state.len() / block);
        let interiors = &mut state[..partition.start(partition.groups()) * block];
        divide(
            scratch,
            groups,
            interiors,
            &|group| partition.start(group) * block,
            &|scratch, groups, state| {
                let second = SecondPass {
                    partition,
                    map,
                    constants,
                    twice,
                    kept,
                    gained,
                    sites,
                    groups,
                    scratch,
                    state,
                };
                M::Kernels::run(Pass::Second(second), level);
            },
        );
        for (place, first, count) in partition.reduced_runs() {
            let gained = &gained[place * block..][..count * block];
            for (x, w) in state[first * block..].iter_mut().zip(gained) {
                *x = w.multiply_add(*twice, *x);
            }
        }
        true
    }
}
