//! Assemblers for straight-line floating-point code, one per processor.
//!
//! In: one call per instruction, on registers and memory. Out: machine code, followed by a pool of
//! constants. The modules of both processors have an `Assembler` and register names with the same
//! interface. Tests compile both modules and compare their bytes with those of other assemblers.

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
    /// Computes a xor b on the bits. Here b is −0, and therefore the sign of a flips.
    ExclusiveOr,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Fused {
    /// Computes product + addend.
    MultiplyAdd,
    /// Computes product − addend.
    MultiplySubtract,
    /// Computes addend − product.
    SubtractProduct,
}

/// The operands of a fused operation, d, b and c, of which two are multiplied. The result
/// overwrites d.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FusedOrder {
    /// Multiplies d by c; b is the addend.
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
    /// Whether the function uses [`GeneralRegister::POINTERS`]; some of these belong to the caller.
    pub(crate) uses_pointers: bool,
    /// The number of vector registers in use, counted from the first register.
    pub(crate) vectors: u8,
    pub(crate) instructions: usize,
}

/// The smallest page size. The stack grows page by page, and therefore pages are touched in order.
const PAGE: usize = 4096;
