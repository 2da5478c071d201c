//! Operands of instructions: formats, registers and memory.

use super::pool::Entry;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Element {
    Single,
    Double,
}

/// The part of a register on which an instruction works: the lowest lane, or 128, 256 or 512 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Width {
    Scalar,
    Bits128,
    Bits256,
    Bits512,
}

/// The element type and the width of an operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct OperandForm {
    pub(crate) element: Element,
    pub(crate) width: Width,
}

impl OperandForm {
    pub(crate) fn bytes(self) -> usize {
        match (self.width, self.element) {
            (Width::Scalar, Element::Single) => 4,
            (Width::Scalar, Element::Double) => 8,
            (Width::Bits128, _) => 16,
            (Width::Bits256, _) => 32,
            (Width::Bits512, _) => 64,
        }
    }

    /// Returns the memory operand at `index` of the array at `base`.
    pub(crate) fn entry<G>(self, base: G, index: usize) -> Memory<G> {
        let offset = i32::try_from(index * self.bytes());
        Memory::At { base, offset: offset.expect("programs are short, and their arrays within reach") }
    }
}

/// The number of a vector register, from 0 to 31.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Vector(pub(crate) u8);

/// A memory operand. G is the processor's type of general-purpose registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Memory<G> {
    /// The address base + offset.
    At { base: G, offset: i32 },
    /// The address base + index. Neither register is the stack pointer.
    Indexed { base: G, index: G },
    /// A number in the constant pool.
    Pool(Entry),
}

/// The last operand of an instruction. M is the type of a memory operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source<M> {
    Register(Vector),
    Memory(M),
}

impl<M> Source<M> {
    pub(crate) fn map<N>(self, of: impl FnOnce(M) -> N) -> Source<N> {
        match self {
            Self::Register(register) => Source::Register(register),
            Self::Memory(place) => Source::Memory(of(place)),
        }
    }
}
