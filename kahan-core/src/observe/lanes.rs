//! Tangent vectors of a group of trajectories, propagated in SIMD lanes.
//!
//! In each lane, the operations are those of a single trajectory, in the same order and not fused.
//! Therefore equal points give equal bits on every instruction set.

use core::array::from_fn;

use crate::composition::Staged;
use crate::ensemble::columns::GROUP;
use crate::ensemble::lanes::{Lanes, OverLanes};
use crate::field::linear::vector;
use crate::map::push_forward_to;
use crate::{EnsembleScalar, ExtendScalars};

use super::growth::most;
use super::{Grouped, SideBySide};

/// The propagation of tangent vectors by one map. If squared lengths are requested, the propagation
/// stops as soon as a vector needs scaling.
pub(super) struct ByOneMap<'a, S, T, P, const N: usize> {
    pub(super) map: &'a S,
    pub(super) work: SideBySide<'a, T, P>,
}

impl<S, T, P, const N: usize> OverLanes<T> for ByOneMap<'_, S, T, P, N>
where
    S: Staged<T, N, Map: ExtendScalars<T, N>>,
    T: EnsembleScalar,
    P: Grouped<T>,
{
    type Output = usize;
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<T>>(self) -> usize {
        let Self { map, work: SideBySide { places, vectors, squares, .. } } = self;
        let stages = map.stages(|at| (at.map.extend_scalars(L::spread), L::spread(&at.eps)));
        let (most, least) = (L::spread(&most()), L::spread(&(T::one() / most())));
        let mut squares = squares.chunks_exact_mut(vectors.len());
        for (step, places) in places.windows(2).enumerate() {
            let mut squares = squares.next();
            let mut is_moderate = true;
            let (place, next) = (places[0].as_ref(), places[1].as_ref());
            for part in (0..GROUP).step_by(L::WIDTH) {
                let x = vector(from_fn(|i| L::load(&place[i], part)));
                let y = vector(from_fn(|i| L::load(&next[i], part)));
                for (k, columns) in vectors.iter_mut().enumerate() {
                    let columns = columns.as_mut();
                    let v = vector(from_fn(|i| L::load(&columns[i], part)));
                    let stages = S::in_order(&stages).map(|(map, eps)| (map, eps));
                    let Some(carried) = push_forward_to(stages, &x, &y, &v) else { continue };
                    let mut squared = L::zero();
                    for (entry, column) in carried.iter().zip(columns) {
                        squared += *entry * *entry;
                        entry.store(column, part);
                    }
                    if let Some(squares) = &mut squares {
                        squared.store(&mut squares[k], part);
                        is_moderate &= !L::any(squared.exceeds(most)) && !L::any(least.exceeds(squared));
                    }
                }
            }
            if !is_moderate {
                return step + 1;
            }
        }
        places.len() - 1
    }
}
