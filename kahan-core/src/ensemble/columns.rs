//! Where an ensemble's numbers lie: one column a variable, in whole groups that begin with cache
//! lines.
//!
//! In: points, one after another. Out: columns that every register width divides, so that no loop
//! has a tail: the last group is filled up with copies of the last point, which nothing outside
//! sees.

use core::array::from_fn;
use std::vec::Vec;

/// As many trajectories as the widest register holds: sixteen `f32`.
pub const GROUP: usize = 16;

/// Consecutive entries of one column.
pub type Group<T> = [T; GROUP];

/// Bytes of a cache line. A register that crosses from one to the next is loaded twice.
const LINE: usize = 64;

/// N columns of equal length in one allocation.
///
/// A column takes an odd number of groups. Equal places of different columns then never lie a
/// multiple of 4096 bytes apart, where caches would make them compete for the same few places.
pub(crate) struct Columns<T, const N: usize> {
    /// Something to skip, then the columns.
    entries: Vec<T>,
    /// Where the first cache line begins.
    start: usize,
    len: usize,
}

impl<T: Copy, const N: usize> Columns<T, N> {
    /// `len` points; `entry(i, c)` is the entry of point `i` in column `c`, asked for column after
    /// column.
    pub(crate) fn new(len: usize, entry: impl Fn(usize, usize) -> T) -> Self {
        if len == 0 || N == 0 {
            return Self { entries: Vec::new(), start: 0, len };
        }
        let stride = stride(len);
        let skipped_at_most = LINE / size_of::<T>().max(1);
        // Never grown beyond its capacity, the allocation stays where it is.
        let mut entries: Vec<T> = Vec::with_capacity(N * stride + skipped_at_most);
        let start = match entries.as_ptr().align_offset(LINE) {
            start if start <= skipped_at_most => start,
            // No place in reach is aligned; nothing but speed depends on it.
            _ => 0,
        };
        entries.resize(start, entry(0, 0));
        for column in 0..N {
            entries.extend((0..stride).map(|i| entry(i.min(len - 1), column)));
        }
        Self { entries, start, len }
    }

    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// The column of variable `c`, without what fills its last group.
    pub(crate) fn column(&self, c: usize) -> &[T] {
        &self.entries[self.start + c * stride(self.len)..][..self.len]
    }

    /// All columns to be written to, filled groups included.
    pub(crate) fn groups_mut(&mut self) -> [&mut [Group<T>]; N] {
        let (stride, used) = (stride(self.len) / GROUP, self.len.div_ceil(GROUP));
        let (mut rest, _) = self.entries[self.start..].as_chunks_mut();
        from_fn(|_| {
            let (column, others) = core::mem::take(&mut rest).split_at_mut(stride);
            rest = others;
            &mut column[..used]
        })
    }
}

/// A copy of its own beginning with a cache line, which a copied vector would not be.
impl<T: Copy, const N: usize> Clone for Columns<T, N> {
    fn clone(&self) -> Self {
        Self::new(self.len, |i, c| self.column(c)[i])
    }
}

/// The entries that a column of `len` entries takes.
fn stride(len: usize) -> usize {
    if len == 0 { 0 } else { (len.div_ceil(GROUP) | 1) * GROUP }
}
