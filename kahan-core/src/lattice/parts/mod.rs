//! A long chain in parts that are eliminated side by side in vector lanes.
//!
//! In: a state. Out: the next one in its place, or nothing where the parts cannot vouch for it. In
//! a first pass every interior is eliminated by itself, and what is left of the separators' rows
//! is one small banded system; with that solved, a second pass finds the interiors. A separator's
//! row is no pivot of an interior: where it meets a pivot much smaller than itself, digits would be
//! lost, and the state is left as it was.

mod buffer;
mod group;
mod joints;
mod kernel;
mod passes;
mod plan;
mod scratch;
mod window;

use std::vec;
use std::vec::Vec;

use crate::Scalar;
use crate::ensemble::Level;
use crate::ensemble::lanes::InLanes;

use super::folded::Folded;
use super::sites::Site;
use super::{Boundary, LatticeMap, LatticeScalar, Shape};

pub(super) use kernel::Kernel;
pub(super) use plan::Plan;
use scratch::Scratch;

/// The memory of steps in parts.
pub(super) struct InParts<T> {
    plan: Plan,
    level: Level,
    /// One for each thread.
    scratch: Vec<Scratch<T>>,
    /// What the first pass says, part by part.
    joints: Vec<T>,
    /// The states of the separators and the sites left over, as they were.
    kept: Vec<T>,
    reduced: Folded<T>,
}

impl<T: Scalar> InParts<T> {
    pub(super) fn new<S: Shape>(plan: Plan, boundary: Boundary, level: Level) -> Self {
        let separator = S::REACH * S::BLOCK;
        let kept = plan.kept() * S::BLOCK;
        #[cfg(feature = "parallel")]
        let threads = rayon::current_num_threads();
        #[cfg(not(feature = "parallel"))]
        let threads = 1;
        Self {
            plan,
            level,
            scratch: (0..threads.min(plan.groups())).map(|_| Scratch::new::<S>(&plan)).collect(),
            joints: vec![T::zero(); plan.parts() * joints::size(separator)],
            kept: vec![T::zero(); kept],
            reduced: Folded::new(kept, boundary == Boundary::Periodic, 2 * separator - 1, 2 * separator - 1),
        }
    }

    /// One step, if the parts can vouch for it; otherwise the state stays as it is.
    pub(super) fn step<M>(
        &mut self,
        map: &M,
        constants: &[T],
        twice: &T,
        site: &mut Site<T>,
        state: &mut [T],
    ) -> bool
    where
        M: LatticeMap<T>,
        T: LatticeScalar + InLanes + Copy + Send + Sync,
    {
        let block = M::Shape::BLOCK;
        for (place, first, count) in self.plan.kept_runs() {
            self.kept[place * block..][..count * block]
                .copy_from_slice(&state[first * block..][..count * block]);
        }
        passes::first(self, map, constants, state);
        let Self { plan, joints, reduced, .. } = self;
        if joints::solve(plan, joints, reduced, map, constants, site, state).is_none() {
            return false;
        }
        passes::second(self, map, constants, twice, state);
        let gained = self.reduced.solution();
        for (place, first, count) in self.plan.kept_runs() {
            let gained = &gained[place * block..][..count * block];
            for (x, w) in state[first * block..].iter_mut().zip(gained) {
                *x = w.multiply_add(*twice, *x);
            }
        }
        true
    }
}
