//! Assemblers for straight-line floating-point code, one per processor.
//!
//! A pool of constants follows the machine code. Tests build both assemblers on every machine, and
//! compare their output with an independent assembler or disassembler.

#[cfg(any(target_arch = "aarch64", test))]
mod a64;
mod operands;
mod pool;
#[cfg(any(not(target_arch = "aarch64"), test))]
mod x86_64;

#[cfg(target_arch = "aarch64")]
pub(crate) use a64::{Assembler, GeneralRegister, Memory};
pub(crate) use operands::{Element, OperandForm, Source, Vector, Width};
#[cfg(not(target_arch = "aarch64"))]
pub(crate) use x86_64::{Assembler, GeneralRegister, Memory};

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    /// Computes a if a > b, else b.
    Maximum,
    /// Computes a if a < b, else b.
    Minimum,
    /// Computes a xor b on the bits. The operand b is −0, which flips the sign of a.
    ExclusiveOr,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Fused {
    MultiplyAdd,
    MultiplySubtract,
    /// Subtracts the product of two operands from the third.
    SubtractProduct,
}

/// Says which of the operands d, b and c are multiplied. The result overwrites d.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FusedOrder {
    /// Multiplies operand 1 (d) by operand 3 (c); operand 2 (b) is the addend.
    D132,
    /// Multiplies b by d; c is the addend.
    D213,
    /// Multiplies b by c; d is the addend.
    D231,
}

/// The registers and the stack that a function uses besides its arguments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FrameNeeds {
    /// The size of the stack slots in bytes. The slots start at the stack pointer.
    pub(crate) stack: usize,
    /// Whether the function uses [`GeneralRegister::POINTERS`], some of which are callee-saved.
    pub(crate) uses_pointers: bool,
    /// The number of vector registers in use, counted from the first register.
    pub(crate) vectors: u8,
    pub(crate) instructions: usize,
}

/// The smallest page size. Functions touch new stack pages in order, as operating systems require.
const PAGE: usize = 4096;
