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
}

/// A register of numbers, from 0 to 31.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Vector(pub(crate) u8);

impl Vector {
    /// What stands where an instruction has no such operand.
    pub(super) const NONE: Self = Vector(0);
}

/// A register of addresses and counts, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(dead_code, reason = "the numbers of registers have no gaps, whichever of them are used")]
pub(crate) enum General {
    Rax,
    Rcx,
    Rdx,
    Rbx,
    Rsp,
    Rbp,
    Rsi,
    Rdi,
    R8,
    R9,
    R10,
    R11,
    R12,
    R13,
    R14,
    R15,
}

/// A place in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Memory {
    /// base + offset
    At { base: General, offset: i32 },
    /// base + index; the index is not `Rsp`.
    Indexed { base: General, index: General },
    /// A number of the pool.
    Pool(Entry),
}

/// The last operand of an instruction; M is what a place in memory is told by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source<M = Memory> {
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
