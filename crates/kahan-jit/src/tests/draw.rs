//! Random programs, drawn from a seed.

use kahan_program::{Float, Node};

use crate::{CalledFunction, Input, Instruction, Program};

/// A random generator (SplitMix64).
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

    /// Draws a random number; larger values of `ordinary` make special numbers such as NaN rarer.
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

/// Appends an operation, even if the program already has it, and returns its node.
pub(crate) fn push(program: &mut Program, operation: Instruction) -> Node {
    program.operations.push(operation);
    Node(program.operations.len() - 1)
}

pub(crate) fn state(i: usize) -> Instruction {
    Instruction::Input(Input::State(i))
}

pub(crate) fn constant(k: usize) -> Instruction {
    Instruction::Input(Input::Constant(k))
}

pub(crate) fn literal(value: f64) -> Instruction {
    Instruction::Constant(Float::of(value))
}

pub(crate) fn random_program(draw: &mut Draw, states: usize, constants: usize, operations: usize) -> Program {
    let mut program = Program::default();
    for i in 0..states {
        push(&mut program, state(i));
    }
    for k in 0..constants {
        push(&mut program, constant(k));
    }
    push(&mut program, literal(draw.number(55)));
    push(&mut program, literal(2.0));
    for _ in 0..operations {
        let known = program.operations.len();
        let mut operand = || match draw.below(3) {
            0 => Node(draw.below(known)),
            _ => Node(known - 1 - draw.below(known.min(6))),
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
            11 => Instruction::Call(CalledFunction::Maximum, a, b),
            12 => Instruction::Call(CalledFunction::Minimum, a, b),
            _ => Instruction::Call(CalledFunction::RoundToSingle, a, a),
        };
        push(&mut program, instruction);
    }
    let known = program.operations.len();
    let result = |draw: &mut Draw| match draw.below(8) {
        0 => Node(draw.below(states + constants + 2)),
        _ => Node(known - 1 - draw.below(known.min(2 * states + 4))),
    };
    program.outputs = (0..states).map(|_| result(draw)).collect();
    program
}
