//! Programs drawn at random from a seed.

use crate::{Instruction, Program};

/// Numbers from a seed (SplitMix64).
pub(crate) struct Draw(pub(crate) u64);

impl Draw {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    pub(crate) fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound as u64) as usize
    }

    /// A number of ordinary size, now and then one of the kinds that are special. Those spread from
    /// result to result, so there are so many `ordinary` numbers for each of them.
    pub(crate) fn number(&mut self, ordinary: usize) -> f64 {
        match self.below(5 + ordinary) {
            0 => 0.0,
            1 => -0.0,
            2 => f64::INFINITY,
            3 => f64::NAN,
            4 => 1e-310,
            _ => (self.next() >> 11) as f64 / (1_u64 << 52) as f64 * 4.0 - 4.0,
        }
    }
}

/// A program of about so many operations with a result for each state, in which most values are
/// used soon and some much later.
pub(crate) fn random_program(draw: &mut Draw, states: usize, constants: usize, operations: usize) -> Program {
    let mut program = Program::default();
    for i in 0..states {
        program.push(Instruction::State(i));
    }
    for k in 0..constants {
        program.push(Instruction::Constant(k));
    }
    program.push(Instruction::literal(draw.number(55)));
    let mut known = 1 + program.push(Instruction::literal(2.0));
    for _ in 0..operations {
        let mut operand = || match draw.below(3) {
            0 => draw.below(known),
            _ => known - 1 - draw.below(known.min(6)),
        };
        let (a, b, c) = (operand(), operand(), operand());
        let instruction = match draw.below(14) {
            0 => Instruction::Add(a, b),
            1 | 2 => Instruction::Subtract(a, b),
            3 | 4 => Instruction::Multiply(a, b),
            5 => Instruction::Divide(a, b),
            6 => Instruction::Negate(a),
            7 | 8 => Instruction::MultiplyAdd(a, b, c),
            9 => Instruction::MultiplySubtract(a, b, c),
            10 => Instruction::SubtractProduct(a, b, c),
            11 => Instruction::Maximum(a, b),
            12 => Instruction::Minimum(a, b),
            _ => Instruction::RoundToSingle(a),
        };
        known = 1 + program.push(instruction);
    }
    // Now and then a state itself, a constant, or one value twice.
    let result = |draw: &mut Draw| match draw.below(8) {
        0 => draw.below(states + constants + 2),
        _ => known - 1 - draw.below(known.min(2 * states + 4)),
    };
    let results = (0..states).map(|_| result(draw)).collect();
    program.set_results(results);
    program
}
