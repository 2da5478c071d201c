//! Assemblers for the instructions that straight lines of floats need, one for each processor.
//!
//! In: one call an instruction, on registers and memory. Out: bytes. The module of a processor has
//! an `Assembler` and the names of its registers; both have the same interface, and code is made by
//! the one of the target. Tests compile the others, too, and compare their bytes with what those
//! who know the processor say.
//!
//! Numbers that stand in the code itself are in a pool behind it.

#[cfg(any(target_arch = "aarch64", test))]
mod a64;
mod operands;
mod pool;
#[cfg(any(not(target_arch = "aarch64"), test))]
mod x86_64;

#[cfg(target_arch = "aarch64")]
pub(crate) use a64::{Assembler, General, Memory};
pub(crate) use operands::{Element, Form, Source, Vector, Width};
#[cfg(not(target_arch = "aarch64"))]
pub(crate) use x86_64::{Assembler, General, Memory};

/// An operation on two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    /// a where a > b, else b
    Maximum,
    /// a where a < b, else b
    Minimum,
    /// The bits of a, those flipped that are set in b, which is −0.
    ExclusiveOr,
}

/// A fused operation on a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Fused {
    /// product + addend
    MultiplyAdd,
    /// product − addend
    MultiplySubtract,
    /// addend − product
    SubtractProduct,
}

/// Which of the operands d, b, c of a fused operation are multiplied; d is overwritten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    /// d·c and b
    D132,
    /// b·d and c
    D213,
    /// b·c and d
    D231,
}

/// The registers and the stack that a function takes beside its arguments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Needs {
    /// The bytes of its slots, which lie above the stack pointer.
    pub(crate) stack: usize,
    /// Whether it uses all of [`General::POINTERS`], some of which its caller finds again as they
    /// were.
    pub(crate) uses_pointers: bool,
    /// The number of registers of numbers that it uses, from the first one on.
    pub(crate) vectors: u8,
    /// The number of machine instructions between its beginning and its end.
    pub(crate) instructions: usize,
}

/// The system enlarges a stack page by page, so that each page is touched before the next one. This
/// is the smallest that pages are.
const PAGE: usize = 4096;
