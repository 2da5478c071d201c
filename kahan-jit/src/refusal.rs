//! Why there is no code.

use crate::InstructionSet;

/// Why there is no code; whoever asked computes in another way.
#[derive(Debug)]
#[non_exhaustive]
pub enum Refusal {
    /// The processor lacks the instructions.
    Unavailable(InstructionSet),
    /// The program is too long for a straight line.
    TooLong {
        /// Its instructions.
        instructions: usize,
    },
    /// The system gives no memory that code may run in.
    Pages(std::io::Error),
}

impl core::fmt::Display for Refusal {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Unavailable(set) => write!(f, "this processor has no {set:?} instructions"),
            Self::TooLong { instructions } => {
                write!(f, "a straight line of {instructions} operations is too long to be compiled")
            }
            Self::Pages(error) => write!(f, "the system gives no memory for code: {error}"),
        }
    }
}

impl core::error::Error for Refusal {}
