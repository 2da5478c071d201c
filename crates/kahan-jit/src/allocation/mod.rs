//! Register allocation for straight-line code.
//!
//! A computed value stays in a register until its last use, unless it is spilled. If no register is
//! free, the value with the farthest next use leaves its register (L. A. Belady, IBM Systems J. 5
//! (1966) 78). A value without a place in memory is stored on the stack. Constants are read from
//! memory, but a loop keeps its most used constants in registers that are otherwise unused.

mod allocator;
mod moves;
mod registers;
mod uses;

use kahan_program::Float;

use crate::assembler::{Binary, Fused, FusedOrder, Source, Vector};
use crate::lowering::ResultDestination;
use crate::program::{Input, Instruction, Program};
use allocator::Allocator;
use uses::Uses;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum ValueLocation {
    State(usize),
    Constant(usize),
    Literal(Float),
    Slot(usize),
    Result(usize),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MachineInstruction {
    Load(Vector, ValueLocation),
    Store(ValueLocation, Vector),
    Copy(Vector, Vector),
    /// Computes `to` = a ∘ b. The fields are ∘, `to`, a and b, in this order.
    Binary(Binary, Vector, Vector, Source<ValueLocation>),
    /// A fused multiply-add. `FusedOrder` says which of the operands `to`, `b`, `c` are multiplied.
    Fused(Fused, FusedOrder, Vector, Vector, Source<ValueLocation>),
    RoundToSingle(Vector, Vector),
}

#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Allocation {
    pub(crate) before: Vec<MachineInstruction>,
    pub(crate) round: Vec<MachineInstruction>,
    pub(crate) after: Vec<MachineInstruction>,
    pub(crate) slots: usize,
    /// The largest number of registers in use at once, without those reserved for constants.
    most_taken: u8,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct RoundPlan {
    pub(crate) ends: ResultDestination,
    /// Whether all rounds of a loop use equal constants, which spare registers can then hold.
    pub(crate) keeps_constants: bool,
}

/// The smallest number of registers: three hold operands, and a fourth helps to move them.
pub(crate) const FEWEST_REGISTERS: u8 = 4;

impl ValueLocation {
    /// Returns where an input or constant is before the code runs; `None` for other instructions.
    fn initial_location(instruction: Instruction) -> Option<Self> {
        match instruction {
            Instruction::Input(Input::State(i)) => Some(Self::State(i)),
            Instruction::Input(Input::Constant(k)) => Some(Self::Constant(k)),
            Instruction::Constant(number) => Some(Self::Literal(number)),
            _ => None,
        }
    }
}

impl MachineInstruction {
    fn load_into(to: Vector, source: Source<ValueLocation>) -> Self {
        match source {
            Source::Register(from) => Self::Copy(to, from),
            Source::Memory(place) => Self::Load(to, place),
        }
    }

    fn written(&self) -> Option<Vector> {
        match *self {
            Self::Store(..) => None,
            Self::Load(to, _)
            | Self::Copy(to, _)
            | Self::Binary(_, to, ..)
            | Self::Fused(_, _, to, ..)
            | Self::RoundToSingle(to, _) => Some(to),
        }
    }
}

impl Allocation {
    /// Allocates registers for a program. At least [`FEWEST_REGISTERS`] must be available.
    pub(crate) fn of(program: &Program, registers: u8, plan: RoundPlan) -> Self {
        let first = Allocator::new(program, registers, plan.ends, &[]).run();
        // Spare registers hold constants that would otherwise be loaded again in each round.
        let kept = constants_in_registers(program, plan, usize::from(registers - first.most_taken));
        if kept.is_empty() { first } else { Allocator::new(program, registers, plan.ends, &kept).run() }
    }

    fn all(&self) -> impl Iterator<Item = &MachineInstruction> {
        self.before.iter().chain(&self.round).chain(&self.after)
    }

    pub(crate) fn instructions(&self) -> usize {
        self.all().count()
    }

    /// Returns the number of the highest vector register in use, plus 1; 0 if none is used.
    pub(crate) fn vectors(&self) -> u8 {
        let written = self.all().filter_map(MachineInstruction::written);
        written.map(|register| register.0 + 1).max().unwrap_or(0)
    }
}

/// Returns at most `most` constants to keep in registers, beginning with the most used one.
fn constants_in_registers(program: &Program, plan: RoundPlan, most: usize) -> Vec<usize> {
    let uses = Uses::of(program);
    let is_kept = |value: &usize| match program.operations[*value] {
        Instruction::Input(Input::Constant(_)) => plan.keeps_constants,
        // If results go elsewhere, the code runs once, and a constant in a register gains nothing.
        Instruction::Constant(_) => plan.ends != ResultDestination::Elsewhere,
        _ => false,
    };
    let mut kept: Vec<usize> = (0..program.operations.len()).filter(is_kept).collect();
    kept.sort_by_key(|value| std::cmp::Reverse(uses.count(*value)));
    kept.truncate(most);
    kept
}
