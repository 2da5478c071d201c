//! Reasons why a program is not compiled.

use crate::Shape;

/// The reason why a program is not compiled. The caller must compute in another way.
#[derive(Debug)]
#[non_exhaustive]
pub enum CompileError {
    /// The processor lacks the instruction set, or the instruction set lacks fused multiply-adds.
    Unavailable(Shape),
    /// The program is too long, or too many values are live at once.
    TooLong {
        /// The number of instructions, or the number of results if this is larger.
        instructions: usize,
    },
    /// The states or constants take more than 2 GiB, which offsets in instructions cannot reach.
    OutOfReach {
        /// The number of states or of constants, whichever is larger.
        entries: usize,
    },
    /// An operation reads a later or nonexistent operation, or a result is a nonexistent operation.
    Malformed,
    /// The system is not supported. On 64-bit Arm, machine code runs only on Linux and Android.
    System,
    /// The operating system refused executable memory.
    Pages(std::io::Error),
}

impl core::fmt::Display for CompileError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Unavailable(Shape { instructions, fuses: true, .. }) if !instructions.has_fused() => {
                write!(f, "{instructions:?} has no multiply-adds that are rounded once")
            }
            Self::Unavailable(shape) => {
                write!(f, "this processor has no {:?} instructions", shape.instructions)
            }
            Self::TooLong { instructions } => {
                write!(f, "a straight line of {instructions} operations is too long to be compiled")
            }
            Self::OutOfReach { entries } => {
                write!(f, "an array of {entries} numbers is longer than an instruction can reach")
            }
            Self::Malformed => write!(f, "an operation or a result reads what was not computed before"),
            Self::System => write!(f, "how code made at run time is entered on this system is not known"),
            Self::Pages(error) => write!(f, "the system gives no memory for code: {error}"),
        }
    }
}

impl core::error::Error for CompileError {}
