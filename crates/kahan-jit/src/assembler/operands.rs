//! What instructions work on.

use super::pool::Entry;

/// A floating-point format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Element {
    Single,
    Double,
}

/// How much of a register an instruction works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Width {
    /// One number.
    Scalar,
    Bits128,
    Bits256,
    Bits512,
}

/// What an operand is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Form {
    pub(crate) element: Element,
    pub(crate) width: Width,
}

impl Form {
    /// The bytes of an operand.
    pub(crate) fn bytes(self) -> usize {
        match (self.width, self.element) {
            (Width::Scalar, Element::Single) => 4,
            (Width::Scalar, Element::Double) => 8,
            (Width::Bits128, _) => 16,
            (Width::Bits256, _) => 32,
            (Width::Bits512, _) => 64,
        }
    }

    /// An entry of the array of operands that begins at a base.
    pub(crate) fn entry<G>(self, base: G, index: usize) -> Memory<G> {
        let offset = i32::try_from(index * self.bytes());
        Memory::At { base, offset: offset.expect("programs are short, and their arrays within reach") }
    }
}

/// A register of numbers, from 0 to 31.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Vector(pub(crate) u8);

/// A place in memory; G is a processor's registers of addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Memory<G> {
    /// base + offset
    At { base: G, offset: i32 },
    /// base + index; neither is the stack pointer.
    Indexed { base: G, index: G },
    /// A number of the pool.
    Pool(Entry),
}

/// The last operand of an instruction; M is what a place in memory is told by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source<M> {
    Register(Vector),
    Memory(M),
}

impl<M> Source<M> {
    /// The same operand, its place in memory told in another way.
    pub(crate) fn map<N>(self, of: impl FnOnce(M) -> N) -> Source<N> {
        match self {
            Self::Register(register) => Source::Register(register),
            Self::Memory(place) => Source::Memory(of(place)),
        }
    }
}
