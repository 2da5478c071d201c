//! A program run once.
#![expect(unsafe_code, reason = "what code does is known where it is written")]

use crate::allocation::{Place, RoundPlan};
use crate::assembler::{General, Memory};
use crate::call::{Code, Extent};
use crate::instructions::{Float, Shape};
use crate::lines::{Ends, Given};
use crate::{Program, Refusal};

use super::{Writer, entry};

/// A program as code that runs once: from states and constants to the results.
#[derive(Debug)]
pub struct Function<T> {
    code: Code<T>,
}

impl<T: Float> Function<T> {
    /// Compiles a program. Cost: some microseconds for a hundred operations.
    ///
    /// # Errors
    /// [`Refusal`].
    pub fn compile(program: &Program, shape: Shape) -> Result<Self, Refusal> {
        let (form, width) = (shape.form::<T>(), shape.width::<T>());
        let plan = RoundPlan { ends: Ends::Elsewhere, keeps_constants: false, keeps_literals: false };
        let mut writer = Writer::begin(program, shape, form, plan, &[])?;
        writer.round(&|_, place| {
            let (base, index) = match place {
                Place::Given(Given::State(i)) => (General::Rdi, i),
                Place::Given(Given::Constant(k)) => (General::Rsi, k),
                Place::Result(i) => (General::Rdx, i),
                Place::Given(Given::Literal(_)) | Place::Slot(_) => {
                    unreachable!("they have addresses already")
                }
            };
            Memory::At { base, offset: entry(form, index) }
        });
        let extent = Extent {
            states: program.states() * width,
            constants: program.constants() * width,
            results: program.results().len() * width,
        };
        // SAFETY: between its beginning and its end, the code reads entries of `program.states()`
        // and `program.constants()` registers, and writes one for each result; its callers enter it
        // by `Code::function`.
        Ok(Function { code: unsafe { Code::new(&writer.leave(), extent) }? })
    }

    /// How many numbers the results are.
    #[must_use]
    pub fn results(&self) -> usize {
        self.code.results()
    }

    /// Computes the results. Where the code works on several numbers at once, each entry of the
    /// three arrays is so many numbers.
    ///
    /// # Panics
    /// If an array is too short.
    pub fn run(&self, states: &[T], constants: &[T], results: &mut [T]) {
        self.code.function(states, constants, results);
    }
}
