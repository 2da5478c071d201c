//! A program run many times on one state, which stays in registers.
#![expect(unsafe_code, reason = "what code does is known where it is written")]

use crate::allocation::{FEWEST_REGISTERS, Place, RoundPlan};
use crate::assembler::{Assembler, Condition, General, Memory};
use crate::call::{Code, Extent};
use crate::instructions::{Float, Shape};
use crate::lines::{Ends, Given};
use crate::{Program, Refusal};

use super::{Writer, entry};

/// A program as code that runs many times: its results are the states of the next round, and its
/// constants stay.
#[derive(Debug)]
pub struct Orbit<T> {
    code: Code<T>,
    ends: Ends,
}

/// The same with several sets of constants, which have their turn in each round one after another.
#[derive(Debug)]
pub struct ComposedOrbit<T> {
    code: Code<T>,
}

impl<T: Float> Orbit<T> {
    /// Compiles a program that has a result for each state.
    ///
    /// # Errors
    /// [`Refusal`].
    ///
    /// # Panics
    /// If a state that is read has no result.
    pub fn compile(program: &Program, shape: Shape) -> Result<Self, Refusal> {
        let (form, ends) = (shape.form::<T>(), ends(program, shape));
        let plan = RoundPlan { ends, keeps_constants: true, keeps_literals: true };
        let mut writer = Writer::begin(program, shape, form, plan, &[])?;
        let addresses = |_: &mut Assembler, place| address(place, General::Rsi, |index| entry(form, index));
        // States that are carried are read from one array and written to another, which may be the
        // same.
        let last = |_: &mut Assembler, place| match place {
            Place::Given(Given::State(i)) => Memory::At { base: General::Rcx, offset: entry(form, i) },
            _ => unreachable!("only states are written at the end"),
        };
        writer.assembler.test(General::Rdx);
        let end = writer.assembler.jump_if_forward(Condition::Zero);
        writer.before(&addresses);
        let again = writer.assembler.label();
        writer.round(&addresses);
        writer.assembler.decrement(General::Rdx);
        writer.assembler.jump_if(Condition::NotZero, again);
        writer.after(&last);
        writer.assembler.bind(end);
        let extent = extent::<T>(program, shape);
        // SAFETY: the code reads a register for each result, and `program.constants()` of them,
        // and writes the results alone, those that are carried to the last state. It is entered by
        // `Code::orbit`, or if they are carried by `Code::orbit_step`.
        let code = unsafe { Code::new(&writer.leave(), extent) }?;
        Ok(Orbit { code, ends })
    }

    /// Advances the state by so many steps.
    ///
    /// # Panics
    /// If an array is too short.
    pub fn run(&self, state: &mut [T], constants: &[T], steps: u64) {
        self.code.orbit(state, constants, steps);
    }

    /// The state one step after another one. Entries are copied by the code itself: a copy before
    /// it would read several at once of those that were just written one by one, and wait for them.
    ///
    /// # Panics
    /// If an array is too short, or `state` and `next` differ in length.
    pub fn step(&self, state: &[T], constants: &[T], next: &mut [T]) {
        if self.ends == Ends::Carried {
            self.code.orbit_step(state, constants, next);
        } else {
            next.copy_from_slice(state);
            self.run(next, constants, 1);
        }
    }
}

impl<T: Float> ComposedOrbit<T> {
    /// Compiles a program that has a result for each state.
    ///
    /// # Errors
    /// [`Refusal`].
    ///
    /// # Panics
    /// If a state that is read has no result.
    pub fn compile(program: &Program, shape: Shape) -> Result<Self, Refusal> {
        let form = shape.form::<T>();
        let plan = RoundPlan { ends: ends(program, shape), keeps_constants: false, keeps_literals: true };
        let mut writer = Writer::begin(program, shape, form, plan, &[])?;
        let addresses = |_: &mut Assembler, place| address(place, General::Rax, |index| entry(form, index));
        writer.assembler.test(General::Rcx);
        let end = writer.assembler.jump_if_forward(Condition::Zero);
        writer.before(&addresses);
        let again = writer.assembler.label();
        writer.assembler.move_general(General::R8, General::Rsi);
        writer.assembler.move_general(General::R9, General::Rdx);
        let next_stage = writer.assembler.label();
        writer.assembler.load_general(General::Rax, General::R8, 0);
        writer.round(&addresses);
        writer.assembler.add_immediate(General::R8, 8);
        writer.assembler.decrement(General::R9);
        writer.assembler.jump_if(Condition::NotZero, next_stage);
        writer.assembler.decrement(General::Rcx);
        writer.assembler.jump_if(Condition::NotZero, again);
        writer.after(&addresses);
        writer.assembler.bind(end);
        let extent = extent::<T>(program, shape);
        // SAFETY: the code reads and writes a register for each result, and reads
        // `program.constants()` of them from each address of the table. It is entered by
        // `Code::composed_orbit`.
        Ok(ComposedOrbit { code: unsafe { Code::new(&writer.leave(), extent) }? })
    }

    /// Advances the state by so many steps, each of all stages; `stages` are their constants.
    ///
    /// # Panics
    /// If an array is too short, or there is no stage, or more than 64.
    pub fn run(&self, state: &mut [T], stages: &[&[T]], steps: u64) {
        self.code.composed_orbit(state, stages, steps);
    }
}

/// Where the states are between two steps: in registers where there is room for the rest.
fn ends(program: &Program, shape: Shape) -> Ends {
    let room = usize::from(shape.instructions.registers() - FEWEST_REGISTERS);
    if program.results().len() <= room { Ends::Carried } else { Ends::InPlace }
}

fn address(place: Place, constants: General, offset: impl Fn(usize) -> i32) -> Memory {
    match place {
        Place::Given(Given::State(i)) => Memory::At { base: General::Rdi, offset: offset(i) },
        Place::Given(Given::Constant(k)) => Memory::At { base: constants, offset: offset(k) },
        _ => unreachable!("an orbit has states and constants"),
    }
}

fn extent<T: Float>(program: &Program, shape: Shape) -> Extent {
    let (width, states) = (shape.width::<T>(), program.results().len());
    Extent { states: states * width, constants: program.constants() * width, results: 0 }
}
