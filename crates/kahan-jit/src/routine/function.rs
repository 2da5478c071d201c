//! Machine code that runs a program once.
#![expect(unsafe_code, reason = "what code does is known where it is written")]

use crate::allocation::{RoundPlan, ValueLocation};
use crate::assembler::GeneralRegister;
use crate::call::Code;
use crate::instructions::{Float, Shape};
use crate::lowering::ResultDestination;
use crate::{CompileError, Program};

use super::Frame;

/// Code that runs a program once, from states and constants to results.
#[derive(Debug)]
pub struct Function<T> {
    code: Code<T>,
}

impl<T: Float> Function<T> {
    /// Compiles a program, in some microseconds per hundred operations.
    ///
    /// # Errors
    /// Returns a [`CompileError`] with the reason.
    pub fn compile(program: &Program, shape: Shape) -> Result<Self, CompileError> {
        let plan = RoundPlan { ends: ResultDestination::Elsewhere, keeps_constants: false };
        let mut frame = Frame::open::<T>(program, shape, plan, false)?;
        let [states, constants, results, ..] = GeneralRegister::ARGUMENTS;
        frame.round(&|assembler, place| match place {
            ValueLocation::State(i) => assembler.form().entry(states, i),
            ValueLocation::Constant(k) => assembler.form().entry(constants, k),
            ValueLocation::Result(i) => assembler.form().entry(results, i),
            ValueLocation::Literal(_) | ValueLocation::Slot(_) => unreachable!("they have addresses already"),
        });
        let (bytes, extent) = frame.close();
        // SAFETY: for each state and constant of the program, the code reads as many numbers as fit
        // a register. For each result it writes as many. Only `Code::function` enters the code.
        Ok(Function { code: unsafe { Code::new(&bytes, extent) }? })
    }

    /// Returns how many numbers the results take.
    #[must_use]
    pub fn results(&self) -> usize {
        let [_, _, results] = self.code.extent().numbers();
        results
    }

    /// Computes the results. Each state, constant and result takes as many numbers as one register
    /// holds.
    ///
    /// # Panics
    /// If an array is too short.
    pub fn run(&self, states: &[T], constants: &[T], results: &mut [T]) {
        self.code.function(states, constants, results);
    }
}
