//! Programs over two input arrays, which hold states and constants.

use kahan_program::{Float, Function, Operation};

/// An entry of one of the two input arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Input {
    /// An entry of the array of states.
    State(usize),
    /// An entry of the array of constants.
    Constant(usize),
}

/// A function that an operation of a program may call.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CalledFunction {
    /// Returns a if a > b, else b.
    Maximum,
    /// Returns a if a < b, else b.
    Minimum,
    /// Rounds to single precision; in single-precision programs, copies the number.
    RoundToSingle,
    /// Copies a number, for results that are inputs or constants.
    Copy,
}

impl Function for CalledFunction {
    fn arguments(&self) -> usize {
        match self {
            Self::Maximum | Self::Minimum => 2,
            Self::RoundToSingle | Self::Copy => 1,
        }
    }
}

/// An operation of a program. Single-precision code rounds the program's constants.
pub type Instruction = Operation<Input, Float, CalledFunction>;

/// A straight-line program with several results.
pub type Program = kahan_program::Program<Vec<Instruction>>;

/// Returns the minimum lengths of the two input arrays, states and constants.
pub(crate) fn entries(program: &Program) -> [usize; 2] {
    let mut entries = [0; 2];
    for input in program.inputs() {
        let (array, index) = match input {
            Input::State(i) => (0, i),
            Input::Constant(k) => (1, k),
        };
        entries[array] = index.saturating_add(1).max(entries[array]);
    }
    entries
}
