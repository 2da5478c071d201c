//! The memory of a group while it is worked on, one for each thread.

use crate::Scalar;
use crate::lattice::Shape;

use super::buffer::Buffer;
use super::partition::Partition;

/// Registers of the sites of a group of parts.
pub(in crate::lattice) struct Scratch<T> {
    /// States, from R sites before the left separator to R after the right one.
    pub(super) x: Buffer<T>,
    /// Parameters of the same sites.
    pub(super) c: Buffer<T>,
    /// The small system that the first pass ends with, and its largest multiplier.
    pub(super) dense: Buffer<T>,
    /// The rows that are done with, rows of the identity first, each with its right-hand side.
    pub(super) done: Buffer<T>,
    /// What the separators to either side gain.
    pub(super) known: Buffer<T>,
}

impl<T: Scalar> Scratch<T> {
    pub(super) fn new<S: Shape>(partition: &Partition) -> Self {
        let (separator, width) = (S::REACH * S::BLOCK, S::LOWER + 1 + S::UPPER);
        let registers = |count: usize| Buffer::new(count * partition.lanes());
        let sites = partition.longest() + 3 * S::REACH;
        let dense = S::LOWER + 2 * separator;
        Self {
            x: registers(sites * S::BLOCK),
            c: registers(sites * S::PARAMETERS),
            dense: registers(dense * (dense + 1) + 1),
            done: registers((partition.longest() * S::BLOCK + S::LOWER) * (width + 1)),
            known: registers(2 * separator),
        }
    }
}
