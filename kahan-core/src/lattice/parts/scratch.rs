//! The memory in which a thread computes one group of parts of a chain.

use crate::Scalar;
use crate::ensemble::Level;
use crate::lattice::Sizes;

use super::buffer::Buffer;
use super::partition::Partition;

pub(in crate::lattice) struct Scratch<T> {
    pub(super) level: Level,
    /// The states of the part, and of neighbouring sites on both sides.
    pub(super) x: Buffer<T>,
    pub(super) c: Buffer<T>,
    pub(super) registers: Buffer<T>,
    /// The dense system that remains of the band, followed by each lane's largest multiplier.
    pub(super) dense: Buffer<T>,
    /// Rows of the identity, followed by the rows of U with their right-hand sides.
    pub(super) done: Buffer<T>,
    /// The solution at the separators to the left and to the right of the part.
    pub(super) known: Buffer<T>,
}

impl<T: Scalar> Scratch<T> {
    pub(super) fn new(sizes: Sizes, partition: &Partition, level: Level) -> Self {
        let Sizes { block, reach, parameters, lower, upper, registers_abreast, .. } = sizes;
        let (separator, width) = (reach * block, lower + 1 + upper);
        let registers = |count: usize| Buffer::new(count * partition.lanes());
        let sites = partition.longest() + 3 * reach;
        let dense = lower + 2 * separator;
        Self {
            level,
            x: registers(sites * block),
            c: registers(sites * parameters),
            registers: registers(registers_abreast),
            dense: registers(dense * (dense + 1) + 1),
            done: registers((partition.longest() * block + lower) * (width + 1)),
            known: registers(2 * separator),
        }
    }
}
