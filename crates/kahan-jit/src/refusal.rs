//! Why there is no code.

use crate::Shape;

/// Why there is no code; whoever asked computes in another way.
#[derive(Debug)]
#[non_exhaustive]
pub enum Refusal {
    /// The processor lacks the instructions, or they do not fuse.
    Unavailable(Shape),
    /// The program is too long for a straight line, or keeps too many numbers at once.
    TooLong {
        /// Its instructions, or its results where there are more of these.
        instructions: usize,
    },
    /// The states or the constants are more than an instruction can reach: 2 GiB of them.
    OutOfReach {
        /// How many the program reads from at least.
        entries: usize,
    },
    /// An operation reads one that does not stand before it, or a result is no operation.
    Malformed,
    /// Nobody has shown that code made at run time is entered as this system wants.
    System,
    /// The system gives no memory that code may run in.
    Pages(std::io::Error),
}

impl core::fmt::Display for Refusal {
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

impl core::error::Error for Refusal {}
