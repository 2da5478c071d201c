//! When each value is used next: what decides which register is given up.

use crate::lowering::SIGN;
use crate::program::{Instruction, Program};

/// The uses of every value, in order.
pub(super) struct Uses {
    uses: Vec<Vec<usize>>,
    /// How many of them are over.
    over: Vec<usize>,
    /// The place of [`SIGN`], which whoever changes a sign reads.
    sign: Option<usize>,
}

impl Uses {
    /// The uses as operands.
    pub(super) fn of(program: &Program) -> Self {
        let mut uses = vec![Vec::new(); program.instructions.len()];
        let sign = program.instructions.iter().position(|instruction| *instruction == SIGN);
        for (time, instruction) in program.instructions.iter().enumerate() {
            let flipped = sign.filter(|_| matches!(instruction, Instruction::Negate(_)));
            instruction.operands().chain(flipped).for_each(|operand| uses[operand].push(time));
        }
        Uses { over: vec![0; uses.len()], uses, sign }
    }

    /// The place of [`SIGN`].
    pub(super) fn sign(&self) -> usize {
        self.sign.unwrap_or_else(|| unreachable!("it stands in every program that changes a sign"))
    }

    /// Notes a use after all that are known.
    pub(super) fn add(&mut self, value: usize, time: usize) {
        self.uses[value].push(time);
    }

    /// The last use of a value.
    pub(super) fn last(&self, value: usize) -> Option<usize> {
        self.uses[value].last().copied()
    }

    /// How often a value is used.
    pub(super) fn count(&self, value: usize) -> usize {
        self.uses[value].len()
    }

    /// The next use of a value; `None` where there is none.
    pub(super) fn next(&self, value: usize) -> Option<usize> {
        self.uses[value].get(self.over[value]).copied()
    }

    /// The next use after `time`.
    pub(super) fn next_after(&self, value: usize, time: usize) -> Option<usize> {
        self.uses[value][self.over[value]..].iter().copied().find(|use_| *use_ > time)
    }

    /// Uses up to `time` are over.
    pub(super) fn end(&mut self, value: usize, time: usize) {
        while self.next(value).is_some_and(|next| next <= time) {
            self.over[value] += 1;
        }
    }
}
