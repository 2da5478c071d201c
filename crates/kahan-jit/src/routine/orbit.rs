//! Code that iterates a program on one state, which stays in registers if there are enough.
#![expect(unsafe_code, reason = "what code does is known where it is written")]

use crate::allocation::{FEWEST_REGISTERS, RoundPlan, ValueLocation};
use crate::assembler::{Assembler, GeneralRegister, Memory};
use crate::call::Code;
use crate::instructions::{Float, Shape};
use crate::lowering::ResultDestination;
use crate::{CompileError, Program};

use super::Frame;

/// Code that iterates a program on its own results, with one set of constants.
#[derive(Debug)]
pub struct Orbit<T> {
    code: Code<T>,
    ends: ResultDestination,
    round_bytes: usize,
}

/// Code that iterates a program. In each round, the program runs once with each set of constants.
#[derive(Debug)]
pub struct ComposedOrbit<T> {
    code: Code<T>,
}

impl<T: Float> Orbit<T> {
    /// Compiles a program with one result per state.
    ///
    /// # Errors
    /// Returns a [`CompileError`] with the reason.
    ///
    /// # Panics
    /// If a state that the program reads has no result.
    pub fn compile(program: &Program, shape: Shape) -> Result<Self, CompileError> {
        let ends = state_destination(program, shape);
        let plan = RoundPlan { ends, keeps_constants: true };
        let mut frame = Frame::open::<T>(program, shape, plan, false)?;
        let [states, constants, steps, last_state, _] = GeneralRegister::ARGUMENTS;
        let addresses = |assembler: &mut Assembler, place| address(assembler, place, states, constants);
        let last = |assembler: &mut Assembler, place| match place {
            ValueLocation::State(i) => assembler.form().entry(last_state, i),
            _ => unreachable!("only states are written at the end"),
        };
        let end = frame.assembler.skip_if_zero(steps);
        frame.before(&addresses);
        let again = frame.assembler.label();
        frame.round(&addresses);
        frame.assembler.count_down(steps, again);
        let round_bytes = frame.assembler.label().0 - again.0;
        frame.after(&last);
        frame.assembler.bind(end);
        let (bytes, extent) = frame.close();
        // SAFETY: the code reads the constants, and as many states as there are results. It writes
        // only states, or only the fourth argument if states stay in registers. Only `Code::orbit`
        // enters the code. If states stay in registers, `Code::orbit_step` enters it, too.
        let code = unsafe { Code::new(&bytes, extent) }?;
        Ok(Orbit { code, ends, round_bytes })
    }

    /// Returns the length in bytes of the code of one round, including the jump back to its start.
    #[must_use]
    pub fn round_bytes(&self) -> usize {
        self.round_bytes
    }

    /// Advances the state by `steps` rounds.
    ///
    /// # Panics
    /// If an array is too short.
    pub fn run(&self, state: &mut [T], constants: &[T], steps: u64) {
        self.code.orbit(state, constants, steps);
    }

    /// Writes the state after one step to `next`. If the states do not fit into registers, this is
    /// slower, because `state` is first copied to `next`.
    ///
    /// # Panics
    /// If an array is too short, or `state` and `next` differ in length.
    pub fn step(&self, state: &[T], constants: &[T], next: &mut [T]) {
        if self.ends == ResultDestination::Carried {
            self.code.orbit_step(state, constants, next);
        } else {
            next.copy_from_slice(state);
            self.run(next, constants, 1);
        }
    }
}

impl<T: Float> ComposedOrbit<T> {
    /// Compiles a program with one result per state.
    ///
    /// # Errors
    /// Returns a [`CompileError`] with the reason.
    ///
    /// # Panics
    /// If a state that the program reads has no result.
    pub fn compile(program: &Program, shape: Shape) -> Result<Self, CompileError> {
        let plan = RoundPlan { ends: state_destination(program, shape), keeps_constants: false };
        let mut frame = Frame::open::<T>(program, shape, plan, false)?;
        // The fifth argument is unused. Its register holds the address of the next table entry.
        let [states, table, stages, steps, entry] = GeneralRegister::ARGUMENTS;
        let [constants, left, _] = GeneralRegister::SPARE;
        let addresses = |assembler: &mut Assembler, place| address(assembler, place, states, constants);
        let end = frame.assembler.skip_if_zero(steps);
        frame.before(&addresses);
        let again = frame.assembler.label();
        frame.assembler.move_general(entry, table);
        frame.assembler.move_general(left, stages);
        let next_stage = frame.assembler.label();
        frame.assembler.load_general(constants, entry, 0);
        frame.round(&addresses);
        frame.assembler.add_immediate(entry, 8);
        frame.assembler.count_down(left, next_stage);
        frame.assembler.count_down(steps, again);
        frame.after(&addresses);
        frame.assembler.bind(end);
        let (bytes, extent) = frame.close();
        // SAFETY: the code reads and writes as many states as there are results. It reads one set
        // of constants at each address in the table. Only `Code::composed_orbit` enters the code.
        Ok(ComposedOrbit { code: unsafe { Code::new(&bytes, extent) }? })
    }

    /// Advances the state by `steps` rounds; `stages` holds the constants of each stage of a round.
    ///
    /// # Panics
    /// If an array is too short, if there are no stages, or if there are more than 64 stages.
    pub fn run<'a>(&self, state: &mut [T], stages: impl Iterator<Item = &'a [T]>, steps: u64) {
        self.code.composed_orbit(state, stages, steps);
    }
}

/// Returns where states live between rounds: in registers if there are enough, otherwise in memory.
fn state_destination(program: &Program, shape: Shape) -> ResultDestination {
    let room = usize::from(shape.instructions.registers() - FEWEST_REGISTERS);
    if program.outputs.len() <= room { ResultDestination::Carried } else { ResultDestination::InPlace }
}

fn address(
    assembler: &Assembler,
    place: ValueLocation,
    states: GeneralRegister,
    constants: GeneralRegister,
) -> Memory {
    match place {
        ValueLocation::State(i) => assembler.form().entry(states, i),
        ValueLocation::Constant(k) => assembler.form().entry(constants, k),
        _ => unreachable!("an orbit has states and constants"),
    }
}
