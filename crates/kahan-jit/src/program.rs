//! Programs over two arrays, one of states and one of constants.

use kahan_program::{Float, Function, Operation};

/// An entry of one of the two input arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Input {
    /// An entry of the states.
    State(usize),
    /// An entry of the constants.
    Constant(usize),
}

/// A function that a program may call.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Called {
    /// The larger of a and b: b unless a > b.
    Maximum,
    /// The smaller of a and b: b unless a < b.
    Minimum,
    /// The single-precision number nearest to a; a itself in a program of single precision.
    RoundToSingle,
    /// A copy of a, for a result that no operation computes.
    Copy,
}

impl Function for Called {
    fn arguments(&self) -> usize {
        match self {
            Self::Maximum | Self::Minimum => 2,
            Self::RoundToSingle | Self::Copy => 1,
        }
    }
}

/// One operation. In single precision, constants of the program are rounded.
pub type Instruction = Operation<Input, Float, Called>;

/// Straight-line operations with several results.
pub type Program = kahan_program::Program<Vec<Instruction>>;

/// Returns the least lengths of states and constants that a program reads.
pub(crate) fn entries(program: &Program) -> [usize; 2] {
    let mut entries = [0; 2];
    for input in program.inputs() {
        let (array, index) = match input {
            Input::State(i) => (0, i),
            Input::Constant(k) => (1, k),
        };
        // Saturates for an index of `usize::MAX`, which no code can reach.
        entries[array] = index.saturating_add(1).max(entries[array]);
    }
    entries
}
