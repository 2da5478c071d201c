//! Computes a step of a chain by elimination with numbers of many digits. Intermediate results may
//! exceed the range of the scalar.

use std::vec::Vec;

use crate::scalar::{LongNumber, equilibrate_row};

use super::folded::FoldedBand;
use super::sites::Site;
use super::{Boundary, LatticeMap, LatticeScalar, Sizes};

/// The maximum number of unknowns. Each unknown needs some kilobytes of memory.
const MOST_UNKNOWNS: usize = 1 << 12;

/// Computes x̃ over long numbers. `long` converts numbers of T to long numbers.
pub(super) fn eliminated<M: LatticeMap<T>, T: LatticeScalar>(
    map: &M,
    eps: &T,
    x: &[T],
    long: impl Fn(&T) -> LongNumber + Copy,
) -> Option<Vec<LongNumber>> {
    if x.len() > MOST_UNKNOWNS {
        return None;
    }
    let eps = long(eps);
    let constants = map.constants(eps.clone(), long)?;
    let Sizes { block, lower, upper, .. } = map.sizes();
    let sites = x.len() / block;
    let is_ring = map.boundary() == Boundary::Periodic;
    let mut site = Site::of(map.sizes());
    let mut folded = FoldedBand::with_little_memory(x.len(), is_ring, lower, upper);
    let velocity = folded.solve(|unknown, row| {
        let (i, b) = (unknown / block, unknown % block);
        site.rows(map, &constants, x, i, long);
        let mut right = site.f(b).clone();
        let mut entries: Vec<(usize, LongNumber)> = site.row(map, sites, b).collect();
        equilibrate_row(entries.iter_mut().map(|(_, entry)| entry), &mut right);
        row.add_right(right);
        entries.into_iter().for_each(|(column, entry)| row.add(column, entry));
    })?;
    let time_step = eps.clone() + eps;
    let next = |(x, velocity): (&T, &LongNumber)| long(x) + time_step.clone() * velocity.clone();
    Some(x.iter().zip(velocity).map(next).collect())
}
