//! The reduced banded system for the solution at the separators and at the sites in no part.

use core::ops::Range;

use crate::lattice::folded::{BandRow, FoldedBand};
use crate::lattice::sites::Site;
use crate::lattice::{LatticeMap, LatticeScalar, Sizes};
use crate::{Constant, Scalar};

use super::partition::Partition;

/// The largest allowed ratio of an entry to its pivot, which loses about three decimal digits.
const MAX_PIVOT_GROWTH: i64 = 1 << 10;

/// Returns the number of numbers stored for a part whose separator has this many unknowns.
pub(super) fn size(separator: usize) -> usize {
    2 * separator * (2 * separator + 1) + 1
}

/// Solves the reduced system. Returns `None` if pivots are too small or numbers are not finite.
pub(super) fn solve<'a, M: LatticeMap<T>, T: LatticeScalar>(
    partition: &Partition,
    joints: &[T],
    reduced: &'a mut FoldedBand<T>,
    map: &M,
    constants: &[T],
    site: &mut Site<T>,
    state: &[T],
) -> Option<&'a [T]> {
    let Sizes { block, reach, .. } = map.sizes();
    let separator = reach * block;
    let (sites, left_over) = (state.len() / block, partition.remaining_sites());
    let joint = |part: usize| &joints[part * size(separator)..][..size(separator)];
    let most = T::constant(&Constant::integer(MAX_PIVOT_GROWTH));
    let is_small = |joint: &[T]| joint.last().is_some_and(|worst| !worst.magnitude_exceeds(&most));
    if !(0..partition.parts()).all(|part| is_small(joint(part))) {
        return None;
    }
    let (left_over_from, place_from) = ((sites - left_over) * block, partition.parts() * separator);
    let gained = reduced.solve(|unknown, row| {
        let (before, k) = (unknown / separator, unknown % separator);
        if (1..=partition.parts()).contains(&before) {
            add(row, joint(before - 1), k, before, separator);
        }
        if before < partition.parts() {
            add(row, joint(before), separator + k, before + 1, separator);
        }
        // Adds the entries of A in `columns` to `row`, from its column `to` on.
        let add_direct = |row: &mut BandRow<'_, T>, site: &Site<T>, b, columns: Range<usize>, to: usize| {
            for (column, entry) in site.entries(map, sites, b) {
                if columns.contains(&column) {
                    row.add(to + column - columns.start, entry.clone());
                }
            }
        };
        let of_left_over = left_over_from..sites * block;
        if unknown >= place_from {
            let own = left_over_from + unknown - place_from;
            site.rows(map, constants, state, own / block, T::clone);
            row.add_right(site.f(own % block).clone());
            add_direct(row, site, own % block, of_left_over, place_from);
            add_direct(row, site, own % block, 0..separator, 0);
        } else if before == 0 {
            site.rows(map, constants, state, unknown / block, T::clone);
            add_direct(row, site, unknown % block, of_left_over, place_from);
        }
    })?;
    gained.iter().all(T::is_finite_number).then_some(gained)
}

/// Adds row k of `joint`, a part's result of the first pass, to `row`. `right` is the index of the
/// part's right separator.
fn add<T: Scalar>(row: &mut BandRow<'_, T>, joint: &[T], k: usize, right: usize, separator: usize) {
    let columns = 2 * separator + 1;
    let entries = &joint[k * columns..][..columns];
    for c in 0..separator {
        row.add(right * separator + c, entries[c].clone());
        row.add((right - 1) * separator + c, entries[separator + c].clone());
    }
    row.add_right(entries[columns - 1].clone());
}
