//! Assemblers for straight-line floating-point code, one per processor.
//!
//! In: one call per instruction, on registers and memory. Out: machine code, with constants in a
//! pool behind it. Both processors' modules have an `Assembler` and register names with one
//! interface. Tests compile both and compare their bytes with those of established assemblers.

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
    /// a if a > b, else b
    Maximum,
    /// a if a < b, else b
    Minimum,
    /// a xor b, bitwise. b is −0, so the sign of a flips.
    ExclusiveOr,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Fused {
    /// product + addend
    MultiplyAdd,
    /// product − addend
    MultiplySubtract,
    /// addend − product
    SubtractProduct,
}

/// Which of the operands d, b, c of a fused operation are multiplied; the result overwrites d.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FusedOrder {
    /// d·c and b
    D132,
    /// b·d and c
    D213,
    /// b·c and d
    D231,
}

/// The registers and stack that a function uses, apart from its arguments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FrameNeeds {
    /// The bytes of its stack slots, which start at the stack pointer.
    pub(crate) stack: usize,
    /// Whether it uses [`GeneralRegister::POINTERS`], some of which must be saved for the caller.
    pub(crate) uses_pointers: bool,
    /// The number of vector registers in use, from the first on.
    pub(crate) vectors: u8,
    pub(crate) instructions: usize,
}

/// The smallest page size; the stack grows page by page, so each page is touched in order.
const PAGE: usize = 4096;
