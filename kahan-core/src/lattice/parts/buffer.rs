//! Memory that is aligned to cache lines where possible. Register loads then cross no line.

use std::vec;
use std::vec::Vec;

use crate::Scalar;

const CACHE_LINE: usize = 64;

pub(super) struct Buffer<T> {
    entries: Vec<T>,
    start: usize,
}

impl<T: Scalar> Buffer<T> {
    pub(super) fn new(len: usize) -> Self {
        let most = CACHE_LINE / size_of::<T>().max(1);
        // The vector never grows; therefore the alignment persists.
        let entries = vec![T::zero(); len + most];
        // If no aligned index can be reached, loads are slower.
        let start =
            Some(entries.as_ptr().align_offset(CACHE_LINE)).filter(|&start| start <= most).unwrap_or(0);
        Self { entries, start }
    }

    pub(super) fn entries(&mut self) -> &mut [T] {
        &mut self.entries[self.start..]
    }
}
