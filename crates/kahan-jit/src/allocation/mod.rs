//! Registers for the values of straight-line code.
//!
//! In: a program that was lowered, and how many registers there are. Out: machine instructions, on
//! registers and memory instead of values. A value stays in a register until its last use; where
//! none is free, that one is given up whose next use is farthest away, which for a straight line is
//! the choice with the fewest loads (L. A. Belady, IBM Systems J. 5 (1966) 78). What is given up
//! and stands nowhere in memory is stored in a slot. Constants are read from memory where they are
//! used; in a loop those used most stand in the registers that are left over.

mod allocator;
mod carried;
mod registers;
mod uses;

use kahan_program::Float;

use crate::assembler::{Binary, Fused, Order, Source, Vector};
use crate::lowering::Ends;
use crate::program::{Input, Instruction, Program};
use allocator::Allocator;
use uses::Uses;

/// A number in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Place {
    State(usize),
    Constant(usize),
    /// A number that the program contains.
    Literal(Float),
    /// Where the code keeps what it has no register for.
    Slot(usize),
    /// An entry of the results.
    Result(usize),
}

/// An instruction on registers and memory: what the assembler has bytes for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MachineInstruction {
    Load(Vector, Place),
    Store(Place, Vector),
    Copy(Vector, Vector),
    /// to, a, b: to = a ∘ b
    Binary(Binary, Vector, Vector, Source<Place>),
    /// to, b, c, in the order of the instruction
    Fused(Fused, Order, Vector, Vector, Source<Place>),
    RoundToSingle(Vector, Vector),
}

/// Straight-line code with its registers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Allocation {
    /// What happens once, before the first round.
    pub(crate) before: Vec<MachineInstruction>,
    /// A round.
    pub(crate) round: Vec<MachineInstruction>,
    /// What happens once, after the last round.
    pub(crate) after: Vec<MachineInstruction>,
    /// How many slots it takes.
    pub(crate) slots: usize,
    /// The most registers that are taken at once, those of what is kept besides.
    most_taken: u8,
}

/// What a routine makes of its program.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoundPlan {
    /// What becomes of the results.
    pub(crate) ends: Ends,
    /// Whether there are many rounds, and the constants are the same in all of them.
    pub(crate) keeps_constants: bool,
}

/// An instruction has three operands, and one more place is needed to bring them there.
pub(crate) const FEWEST_REGISTERS: u8 = 4;

impl Place {
    /// Where a value lies before the first round, if it is not computed.
    fn given(instruction: Instruction) -> Option<Self> {
        match instruction {
            Instruction::Input(Input::State(i)) => Some(Self::State(i)),
            Instruction::Input(Input::Constant(k)) => Some(Self::Constant(k)),
            Instruction::Constant(number) => Some(Self::Literal(number)),
            _ => None,
        }
    }
}

impl MachineInstruction {
    /// Brings a number into a register.
    fn bring(to: Vector, source: Source<Place>) -> Self {
        match source {
            Source::Register(from) => Self::Copy(to, from),
            Source::Memory(place) => Self::Load(to, place),
        }
    }

    /// The register that it writes to.
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
    /// `registers` is how many there are, at least [`FEWEST_REGISTERS`].
    pub(crate) fn of(program: &Program, registers: u8, plan: RoundPlan) -> Self {
        let first = Allocator::new(program, registers, plan.ends, &[]).run();
        // Registers that nothing else takes hold what would be read again in each round.
        let kept = kept(program, plan, usize::from(registers - first.most_taken));
        if kept.is_empty() { first } else { Allocator::new(program, registers, plan.ends, &kept).run() }
    }

    fn all(&self) -> impl Iterator<Item = &MachineInstruction> {
        self.before.iter().chain(&self.round).chain(&self.after)
    }

    /// The number of instructions.
    pub(crate) fn instructions(&self) -> usize {
        self.all().count()
    }

    /// The number of registers from the first one to the last one that is written to.
    pub(crate) fn vectors(&self) -> u8 {
        let written = self.all().filter_map(MachineInstruction::written);
        written.map(|register| register.0 + 1).max().unwrap_or(0)
    }
}

/// Constants and literals that are read in each round, the most used first.
fn kept(program: &Program, plan: RoundPlan, most: usize) -> Vec<usize> {
    let uses = Uses::of(program);
    let is_kept = |value: &usize| match program.operations[*value] {
        Instruction::Input(Input::Constant(_)) => plan.keeps_constants,
        // Results that lie elsewhere are those of a single round.
        Instruction::Constant(_) => plan.ends != Ends::Elsewhere,
        _ => false,
    };
    let mut kept: Vec<usize> = (0..program.operations.len()).filter(is_kept).collect();
    kept.sort_by_key(|value| std::cmp::Reverse(uses.count(*value)));
    kept.truncate(most);
    kept
}
