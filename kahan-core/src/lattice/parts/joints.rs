//! What joins the parts: the banded system of the separators and the sites left over.
//!
//! In: what the first pass leaves of the separators' rows. Out: what these sites gain.

use core::ops::Range;

use crate::lattice::folded::{BandRow, Folded};
use crate::lattice::sites::Site;
use crate::lattice::{LatticeMap, LatticeScalar, Sizes};
use crate::{Constant, Scalar};

use super::partition::Partition;

/// How many times as large as its pivot an entry of a separator's row may be, 2¹⁰: three digits of
/// the sixteen.
const GROWTH: i64 = 1 << 10;

/// Numbers that a part leaves, for separators of so many unknowns: its rows, and the largest
/// multiplier.
pub(super) fn size(separator: usize) -> usize {
    2 * separator * (2 * separator + 1) + 1
}

/// What the sites of the reduced system gain; `None` where pivots were too small, or numbers are
/// not finite.
pub(super) fn solve<'a, M: LatticeMap<T>, T: LatticeScalar>(
    partition: &Partition,
    joints: &[T],
    reduced: &'a mut Folded<T>,
    map: &M,
    constants: &[T],
    site: &mut Site<T>,
    state: &[T],
) -> Option<&'a [T]> {
    let Sizes { block, reach, .. } = map.sizes();
    let separator = reach * block;
    let (sites, left_over) = (state.len() / block, partition.left_over());
    let joint = |part: usize| &joints[part * size(separator)..][..size(separator)];
    let most = T::constant(&Constant::integer(GROWTH));
    let is_small = |joint: &[T]| joint.last().is_some_and(|worst| !worst.magnitude_exceeds(&most));
    if !(0..partition.parts()).all(|part| is_small(joint(part))) {
        return None;
    }
    let (left_over_from, place_from) = ((sites - left_over) * block, partition.parts() * separator);
    let gained = reduced.solve(|unknown, row| {
        let (before, k) = (unknown / separator, unknown % separator);
        // A row of the part to the left, then of the one to the right.
        if (1..=partition.parts()).contains(&before) {
            add(row, joint(before - 1), k, before, separator);
        }
        if before < partition.parts() {
            add(row, joint(before), separator + k, before + 1, separator);
        }
        // What no part has seen: couplings among the sites left over, and with the first separator.
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

/// Adds row k of what a part leaves; `right` counts the separator to its right.
fn add<T: Scalar>(row: &mut BandRow<'_, T>, joint: &[T], k: usize, right: usize, separator: usize) {
    let columns = 2 * separator + 1;
    let entries = &joint[k * columns..][..columns];
    for c in 0..separator {
        row.add(right * separator + c, entries[c].clone());
        row.add((right - 1) * separator + c, entries[separator + c].clone());
    }
    row.add_right(entries[columns - 1].clone());
}
