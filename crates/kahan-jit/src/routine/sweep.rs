//! Code that iterates a program over columns of trajectories, one SIMD register at a time.
#![expect(unsafe_code, reason = "what code does is known where it is written")]

use crate::allocation::{RoundPlan, ValueLocation};
use crate::assembler::{Assembler, GeneralRegister, Memory};
use crate::call::Code;
use crate::instructions::{Float, Shape};
use crate::lowering::ResultDestination;
use crate::{CompileError, Program};

use super::Frame;

/// Says whether all trajectories of a sweep run with equal constants.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Constants {
    /// All trajectories share one set of constants.
    Shared,
    /// Each group of trajectories that share a SIMD register has its own set of constants.
    Own,
}

/// Code that advances many trajectories. Column i holds state i of each trajectory.
#[derive(Debug)]
pub struct Sweep<T> {
    code: Code<T>,
    of: Constants,
}

impl<T: Float> Sweep<T> {
    /// Compiles a program with one result per state.
    ///
    /// # Errors
    /// Returns a [`CompileError`] with the reason.
    ///
    /// # Panics
    /// If a state that the program reads has no result.
    pub fn compile(program: &Program, shape: Shape, of: Constants) -> Result<Self, CompileError> {
        let plan = RoundPlan { ends: ResultDestination::InPlace, keeps_constants: of == Constants::Shared };
        let mut frame = Frame::open::<T>(program, shape, plan, true)?;
        let [table, length, constants, stride, steps] = GeneralRegister::ARGUMENTS;
        let [column_address, index, own] = GeneralRegister::SPARE;
        for (column, pointer) in GeneralRegister::POINTERS.into_iter().enumerate().take(program.outputs.len())
        {
            frame.assembler.load_general(pointer, table, place_of(column));
        }
        let addresses = |assembler: &mut Assembler, place| match place {
            ValueLocation::State(i) => {
                let base = GeneralRegister::POINTERS.get(i).copied().unwrap_or_else(|| {
                    assembler.load_general(column_address, table, place_of(i));
                    column_address
                });
                Memory::Indexed { base, index }
            }
            ValueLocation::Constant(k) => assembler.form().entry(own, k),
            _ => unreachable!("a sweep has states and constants"),
        };
        frame.assembler.move_general(own, constants);
        frame.before(&addresses);
        let next_step = frame.assembler.label();
        frame.assembler.clear(index);
        frame.assembler.move_general(own, constants);
        let next_register = frame.assembler.label();
        frame.round(&addresses);
        if of == Constants::Own {
            frame.assembler.add_general(own, stride);
        }
        frame.assembler.add_immediate(index, frame.assembler.form().bytes() as i32);
        frame.assembler.repeat_below(index, length, next_register);
        frame.assembler.count_down(steps, next_step);
        let (bytes, extent) = frame.close();
        // SAFETY: the code reads and writes the first `states` columns register by register. For
        // each constant it reads one register, from the array of constants. Only `Code::sweep`
        // enters the code, with the register width and with the stride between sets of constants.
        Ok(Sweep { code: unsafe { Code::new(&bytes, extent) }?, of })
    }

    /// Returns the number of trajectories per SIMD register, which must divide the columns' length.
    #[must_use]
    pub fn width(&self) -> usize {
        self.code.extent().width
    }

    /// Returns how many numbers one set of constants takes.
    #[must_use]
    pub fn constants(&self) -> usize {
        let [_, constants, _] = self.code.extent().numbers();
        constants
    }

    /// Advances all trajectories by `steps` rounds. Each set of constants holds each number once
    /// per lane. With [`Constants::Own`], the sets of the groups of trajectories follow each other.
    ///
    /// # Panics
    /// If the columns differ in length, or the length is not a multiple of [`width`](Self::width).
    /// If there are too few constants or more than 256 columns.
    pub fn run(&self, columns: &mut [impl AsMut<[T]>], constants: &[T], steps: u64) {
        self.code.sweep(columns, constants, self.of == Constants::Own, steps);
    }
}

fn place_of(column: usize) -> i32 {
    i32::try_from(8 * column).expect("there are fewer columns than instructions")
}
