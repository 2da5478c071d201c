//! The memory of an ensemble: one aligned column per variable, in whole groups of points.
//!
//! Every register width divides the length of a group; therefore loops have no remainder. Copies of
//! the last point fill the last group, and are never visible outside.

use core::array::from_fn;
use std::vec::Vec;

/// The number of points in a group, which is the number of `f32` in the widest register.
pub const GROUP: usize = 16;

/// The entries of one column for a group of consecutive points.
pub type Group<T> = [T; GROUP];

/// The bytes of a cache line. Loading a register that crosses a line costs two loads.
const CACHE_LINE: usize = 64;

/// N columns of equal length in one allocation.
///
/// Column starts are an odd number of groups apart. Therefore the entries with index i of 32
/// successive columns lie in different sets of the first-level cache.
pub(crate) struct Columns<T, const N: usize> {
    entries: Vec<T>,
    /// The index of the first entry, which lies at the start of a cache line.
    start: usize,
    len: usize,
}

impl<T: Copy, const N: usize> Columns<T, N> {
    /// Creates `len` points, column by column. `entry(i, c)` returns variable `c` of point `i`.
    pub(crate) fn new(len: usize, entry: impl Fn(usize, usize) -> T) -> Self {
        if len == 0 || N == 0 {
            return Self { entries: Vec::new(), start: 0, len };
        }
        let stride = stride(len);
        let skipped_at_most = CACHE_LINE / size_of::<T>().max(1);
        // The vector never outgrows its capacity; therefore the alignment persists.
        let mut entries: Vec<T> = Vec::with_capacity(N * stride + skipped_at_most);
        let start = match entries.as_ptr().align_offset(CACHE_LINE) {
            start if start <= skipped_at_most => start,
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

    pub(crate) fn column(&self, c: usize) -> &[T] {
        &self.entries[self.start + c * stride(self.len)..][..self.len]
    }

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

/// A cloned vector would not be aligned; therefore the entries are copied.
impl<T: Copy, const N: usize> Clone for Columns<T, N> {
    fn clone(&self) -> Self {
        Self::new(self.len, |i, c| self.column(c)[i])
    }
}

/// Returns the number of entries reserved for a column of `len` points.
fn stride(len: usize) -> usize {
    if len == 0 { 0 } else { (len.div_ceil(GROUP) | 1) * GROUP }
}
