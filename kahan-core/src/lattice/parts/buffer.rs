//! Memory that begins with a cache line, so that no register is loaded from two of them.

use std::vec;
use std::vec::Vec;

use crate::Scalar;

/// Bytes of a cache line.
const LINE: usize = 64;

/// Numbers from the beginning of a cache line on.
pub(super) struct Buffer<T> {
    entries: Vec<T>,
    start: usize,
}

impl<T: Scalar> Buffer<T> {
    pub(super) fn new(len: usize) -> Self {
        let most = LINE / size_of::<T>().max(1);
        // Never grown, the allocation stays where it is.
        let entries = vec![T::zero(); len + most];
        // Should no place in reach be aligned, nothing but speed suffers.
        let start = Some(entries.as_ptr().align_offset(LINE)).filter(|&start| start <= most).unwrap_or(0);
        Self { entries, start }
    }

    pub(super) fn entries(&mut self) -> &mut [T] {
        &mut self.entries[self.start..]
    }
}
