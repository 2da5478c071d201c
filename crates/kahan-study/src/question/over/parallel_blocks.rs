//! Computes blocks of rows on all threads of a watch, and passes them to a consumer in order.

use std::ops::Range;

use kahan_discover::Watch;
use kahan_runtime::{End, threads};

use crate::count::WorkCount;
use crate::rows::{Rows, Table};

/// The number of blocks that each thread computes before rows are passed on.
const BLOCKS_PER_THREAD: u64 = 64;

/// A function that computes the rows of some cells. The callback gets the number of finished cells,
/// and returns `false` to end the work.
pub(super) type RowComputation<'a> = dyn Fn(Range<u64>, &dyn Fn(u64) -> bool) -> Table + Sync + 'a;

/// Passes the rows of a range, in order, to a consumer; a block has `least` to `most` cells. If the
/// work ends early, returns [`End::Stopped`] with the number of the first missing row.
pub(super) fn in_parallel_blocks(
    range: Range<u64>,
    [least, most]: [u64; 2],
    make: &RowComputation<'_>,
    rows: &mut dyn Rows,
    watch: &dyn Watch,
) -> End {
    let (threads, count) = (watch.threads() as u64, range.end - range.start);
    let block = match threads {
        1 => most,
        _ => (count / (8 * threads)).next_multiple_of(least).clamp(least, most),
    };
    let told = WorkCount::new("cells", count, watch);
    let goes_on = |more: u64| told.tell(more).is_continue();
    let blocks = count.div_ceil(block);
    for first in (0..blocks).step_by((BLOCKS_PER_THREAD * threads) as usize) {
        let cells = |place: usize| {
            let start = range.start + (first + place as u64) * block;
            start..range.end.min(start + block)
        };
        let wave = (BLOCKS_PER_THREAD * threads).min(blocks - first) as usize;
        let tables = threads::map(wave, Some(threads as usize), |place| make(cells(place), &goes_on));
        for (place, table) in tables.iter().enumerate() {
            let own = cells(place);
            let has_ended = table.count() > 0 && table.pass_to(rows).is_break();
            if has_ended || (table.count() as u64) < own.end - own.start {
                return End::Stopped(own.start + table.count() as u64);
            }
        }
    }
    End::Complete
}
