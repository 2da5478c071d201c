//! The later uses of each value, which decide which value is spilled.

use crate::lowering::SIGN_BIT;
use crate::program::{Instruction, Program};

pub(super) struct Uses {
    /// The times of all uses, grouped by value. Each group has a spare entry, which `add` may fill.
    times: Vec<u32>,
    /// For each value, the range of its remaining uses in `times`.
    of: Vec<[usize; 2]>,
    /// The index of the constant [`SIGN_BIT`], which negations read implicitly.
    sign: Option<usize>,
}

impl Uses {
    pub(super) fn of(program: &Program) -> Self {
        let sign = program.operations.iter().position(|instruction| *instruction == SIGN_BIT);
        let operands = |instruction: &Instruction| {
            let flipped = sign.filter(|_| matches!(instruction, Instruction::Negate(_)));
            instruction.operands().map(|operand| operand.0).chain(flipped)
        };
        let mut counts = vec![1; program.operations.len()];
        program.operations.iter().flat_map(operands).for_each(|operand| counts[operand] += 1);
        let mut begin = 0;
        let mut of: Vec<[usize; 2]> = Vec::with_capacity(counts.len());
        for count in counts {
            of.push([begin; 2]);
            begin += count;
        }
        let mut uses = Uses { times: vec![0; begin], of, sign };
        for (time, instruction) in program.operations.iter().enumerate() {
            operands(instruction).for_each(|operand| uses.push(operand, time));
        }
        uses
    }

    fn push(&mut self, value: usize, time: usize) {
        let [_, end] = &mut self.of[value];
        self.times[*end] = u32::try_from(time).expect("programs are short");
        *end += 1;
    }

    fn left(&self, value: usize) -> impl DoubleEndedIterator<Item = usize> + ExactSizeIterator {
        let [first, end] = self.of[value];
        self.times[first..end].iter().map(|time| *time as usize)
    }

    pub(super) fn sign(&self) -> usize {
        self.sign.unwrap_or_else(|| unreachable!("it stands in every program that changes a sign"))
    }

    /// Adds a use at `time`, unless it is recorded already. Uses of a value are added in order.
    pub(super) fn add(&mut self, value: usize, time: usize) {
        if self.last(value) != Some(time) {
            self.push(value, time);
        }
    }

    pub(super) fn last(&self, value: usize) -> Option<usize> {
        self.left(value).next_back()
    }

    pub(super) fn count(&self, value: usize) -> usize {
        self.left(value).len()
    }

    pub(super) fn next(&self, value: usize) -> Option<usize> {
        self.left(value).next()
    }

    pub(super) fn next_after(&self, value: usize, time: usize) -> Option<usize> {
        self.left(value).find(|use_| *use_ > time)
    }

    pub(super) fn end(&mut self, value: usize, time: usize) {
        while self.next(value).is_some_and(|next| next <= time) {
            self.of[value][0] += 1;
        }
    }
}
