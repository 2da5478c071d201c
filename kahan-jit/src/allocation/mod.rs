//! Registers for the values of straight-line code.
//!
//! In: lines, and how many registers there are. Out: operations on registers and memory. A value
//! stays in a register until its last use; where none is free, that one is given up whose next use
//! is farthest away, which for a straight line is the choice with the fewest loads (L. A. Belady,
//! IBM Systems J. 5 (1966) 78). What is given up and stands nowhere in memory is stored in a slot.
//! Constants are read from memory where they are used; in a loop those used most stand in the
//! registers that are left over.

mod allocator;
mod carried;
mod registers;
mod uses;

use crate::assembler::{Binary, Fused, Order, Vector};
use crate::lines::{Ends, Given, Line, Lines};
use allocator::Allocator;
use uses::Uses;

/// A number in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Given(Given),
    /// Where the code keeps what it has no register for.
    Slot(usize),
    /// An entry of the results.
    Result(usize),
}

/// The last operand of an operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operand {
    Register(Vector),
    Memory(Place),
}

/// What the machine is to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operation {
    Load(Vector, Place),
    Store(Place, Vector),
    Copy(Vector, Vector),
    /// to, a, b: to = a ∘ b
    Binary(Binary, Vector, Vector, Operand),
    /// to, b, c, in the order of the instruction
    Fused(Fused, Order, Vector, Vector, Operand),
    RoundToSingle(Vector, Vector),
}

/// Straight-line code with its registers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Allocation {
    /// What happens once, before the first round.
    pub(crate) before: Vec<Operation>,
    /// A round.
    pub(crate) round: Vec<Operation>,
    /// What happens once, after the last round.
    pub(crate) after: Vec<Operation>,
    /// How many slots it takes.
    pub(crate) slots: usize,
}

/// What a routine makes of its lines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoundPlan {
    /// What becomes of the results.
    pub(crate) ends: Ends,
    /// Whether there are many rounds, and the constants are the same in all of them.
    pub(crate) keeps_constants: bool,
    /// Whether there are many rounds.
    pub(crate) keeps_literals: bool,
}

/// An operation has three operands, and one more place is needed to bring them there.
pub(crate) const FEWEST_REGISTERS: u8 = 4;

impl Operation {
    /// Brings a number into a register.
    fn bring(to: Vector, source: Operand) -> Self {
        match source {
            Operand::Register(from) => Self::Copy(to, from),
            Operand::Memory(place) => Self::Load(to, place),
        }
    }
}

impl Allocation {
    /// `registers` is how many there are, at least [`FEWEST_REGISTERS`].
    pub(crate) fn of(lines: &Lines, registers: u8, plan: RoundPlan) -> Self {
        let first = Allocator::new(lines, registers, plan.ends, &[]).run();
        // Registers that nothing else takes hold what would be read again in each round.
        let left = registers - first.most_taken;
        let kept = kept(lines, plan, usize::from(left));
        let (code, kept) = if kept.is_empty() {
            (first, Vec::new())
        } else {
            let code = Allocator::new(lines, registers, plan.ends, &kept);
            let loads = code.kept_registers(&kept);
            (code.run(), loads)
        };
        let given = |line: usize| match lines.lines[line] {
            Line::Given(given) => Place::Given(given),
            _ => unreachable!("what is kept is given"),
        };
        let mut before: Vec<Operation> =
            kept.iter().map(|(line, register)| Operation::Load(*register, given(*line))).collect();
        let mut after = Vec::new();
        if plan.ends == Ends::Carried {
            for i in 0..lines.results.len() {
                let (place, register) = (Place::Given(Given::State(i)), Vector(i as u8));
                before.push(Operation::Load(register, place));
                after.push(Operation::Store(place, register));
            }
        }
        Allocation { before, round: code.operations, after, slots: code.slots }
    }
}

/// Constants and literals that are read in each round, the most used first.
fn kept(lines: &Lines, plan: RoundPlan, most: usize) -> Vec<usize> {
    let uses = Uses::of(lines);
    let is_kept = |line: &usize| match lines.lines[*line] {
        Line::Given(Given::Constant(_)) => plan.keeps_constants,
        Line::Given(Given::Literal(_)) => plan.keeps_literals,
        _ => false,
    };
    let mut kept: Vec<usize> = (0..lines.lines.len()).filter(is_kept).collect();
    kept.sort_by_key(|line| std::cmp::Reverse(uses.count(*line)));
    kept.truncate(most);
    kept
}
