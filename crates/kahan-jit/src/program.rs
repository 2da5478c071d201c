//! A straight line of float operations: what becomes machine code.
//!
//! Instructions over two arrays, one of states and one of constants, with several results. What the
//! numbers mean is not known here.

/// One instruction; operands are the indices of earlier ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Instruction {
    /// An entry of the states.
    State(usize),
    /// An entry of the constants.
    Constant(usize),
    /// A number, by its bits in double precision; single precision takes the nearest one it has.
    Literal(u64),
    /// a + b
    Add(usize, usize),
    /// a − b
    Subtract(usize, usize),
    /// a·b
    Multiply(usize, usize),
    /// a/b
    Divide(usize, usize),
    /// The larger of a and b: b unless a > b
    Maximum(usize, usize),
    /// The smaller of a and b: b unless a < b
    Minimum(usize, usize),
    /// −a
    Negate(usize),
    /// a·b + c, rounded once where multiply-adds are fused
    MultiplyAdd(usize, usize, usize),
    /// a·b − c, likewise
    MultiplySubtract(usize, usize, usize),
    /// a − b·c, likewise
    SubtractProduct(usize, usize, usize),
    /// The same number in a place of its own: what a result is that no operation computes.
    Copy(usize),
    /// The number of single precision nearest to a; a itself in a program of single precision.
    RoundToSingle(usize),
}

use Instruction::*;

/// Straight-line instructions with several results.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Program {
    pub(crate) instructions: Vec<Instruction>,
    pub(crate) results: Vec<usize>,
}

impl Program {
    /// Appends an instruction; its index.
    ///
    /// # Panics
    /// If an operand is not an earlier instruction.
    pub fn push(&mut self, instruction: Instruction) -> usize {
        let index = self.instructions.len();
        assert!(instruction.operands().all(|operand| operand < index), "an operand comes before its use");
        self.instructions.push(instruction);
        index
    }

    /// Sets the results, in their order.
    ///
    /// # Panics
    /// If one of them is no instruction.
    pub fn set_results(&mut self, results: Vec<usize>) {
        assert!(results.iter().all(|result| *result < self.instructions.len()), "a result is an instruction");
        self.results = results;
    }

    /// The instruction with this index.
    ///
    /// # Panics
    /// If there is none.
    #[must_use]
    pub fn instruction(&self, index: usize) -> Instruction {
        self.instructions[index]
    }

    /// The results, in their order.
    #[must_use]
    pub fn results(&self) -> &[usize] {
        &self.results
    }

    /// How many states the program reads at least.
    #[must_use]
    pub fn states(&self) -> usize {
        self.entries(|instruction| matches!(instruction, State(_)))
    }

    /// How many constants the program reads at least.
    #[must_use]
    pub fn constants(&self) -> usize {
        self.entries(|instruction| matches!(instruction, Constant(_)))
    }

    fn entries(&self, of_kind: impl Fn(&Instruction) -> bool) -> usize {
        let entries = self.instructions.iter().filter(|instruction| of_kind(instruction));
        let entry = |instruction: &Instruction| match *instruction {
            // There may be one more than can be counted; no code reaches that far.
            State(index) | Constant(index) => index.saturating_add(1),
            _ => 0,
        };
        entries.map(entry).max().unwrap_or(0)
    }
}

impl Instruction {
    /// A number.
    #[must_use]
    pub fn literal(value: f64) -> Self {
        Literal(value.to_bits())
    }

    /// The operands in order.
    pub(crate) fn operands(&self) -> impl Iterator<Item = usize> + use<> {
        let operands = match *self {
            State(_) | Constant(_) | Literal(_) => [None, None, None],
            Negate(a) | Copy(a) | RoundToSingle(a) => [Some(a), None, None],
            Add(a, b) | Subtract(a, b) | Multiply(a, b) | Divide(a, b) | Maximum(a, b) | Minimum(a, b) => {
                [Some(a), Some(b), None]
            }
            MultiplyAdd(a, b, c) | MultiplySubtract(a, b, c) | SubtractProduct(a, b, c) => {
                [Some(a), Some(b), Some(c)]
            }
        };
        operands.into_iter().flatten()
    }

    /// The same instruction on other operands.
    pub(crate) fn with_operands(mut self, rename: impl Fn(usize) -> usize) -> Self {
        match &mut self {
            State(_) | Constant(_) | Literal(_) => {}
            Negate(a) | Copy(a) | RoundToSingle(a) => *a = rename(*a),
            Add(a, b) | Subtract(a, b) | Multiply(a, b) | Divide(a, b) | Maximum(a, b) | Minimum(a, b) => {
                (*a, *b) = (rename(*a), rename(*b));
            }
            MultiplyAdd(a, b, c) | MultiplySubtract(a, b, c) | SubtractProduct(a, b, c) => {
                (*a, *b, *c) = (rename(*a), rename(*b), rename(*c));
            }
        }
        self
    }
}
