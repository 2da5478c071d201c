//! The arithmetic whose numbers are instructions: a plan that is evaluated in it is written down.

use std::cell::RefCell;

use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::rational::Rational;
use kahan_jit::{Instruction, Program};

use Instruction::*;

/// A program that is being written.
#[derive(Debug)]
pub(super) struct Recorder {
    program: RefCell<Program>,
    /// The float nearest to a number, of the precision that the program runs in.
    nearest: fn(&Rational) -> f64,
}

impl Recorder {
    /// An empty program whose numbers are rounded by `nearest`.
    pub(super) fn new(nearest: fn(&Rational) -> f64) -> Self {
        Recorder { program: RefCell::default(), nearest }
    }

    /// Writes an instruction.
    pub(super) fn push(&self, instruction: Instruction) -> usize {
        self.program.borrow_mut().push(instruction)
    }

    /// The number −a of an instruction that changes a sign: what a subtraction takes instead.
    pub(super) fn negated(&self, number: usize) -> Option<usize> {
        match self.program.borrow().instruction(number) {
            Negate(inner) => Some(inner),
            _ => None,
        }
    }

    /// The number that an instruction is, where it is one.
    pub(super) fn literal(&self, number: usize) -> Option<f64> {
        match self.program.borrow().instruction(number) {
            Literal(value) => Some(value),
            _ => None,
        }
    }

    /// The program with these results.
    pub(super) fn finish(self, results: Vec<usize>) -> Program {
        let mut program = self.program.into_inner();
        program.set_results(results);
        program
    }
}

impl Arithmetic for Recorder {
    type Value = usize;

    fn constant(&self, value: &Rational) -> Option<usize> {
        Some(self.push(Literal((self.nearest)(value))))
    }

    fn add(&self, a: &usize, b: &usize) -> usize {
        self.push(Add(*a, *b))
    }

    fn subtract(&self, a: &usize, b: &usize) -> usize {
        self.push(Subtract(*a, *b))
    }

    fn multiply(&self, a: &usize, b: &usize) -> usize {
        self.push(Multiply(*a, *b))
    }

    fn negate(&self, a: &usize) -> usize {
        self.push(Negate(*a))
    }

    fn divide(&self, a: &usize, b: &usize) -> Option<usize> {
        Some(self.push(Divide(*a, *b)))
    }

    fn multiply_add(&self, a: &usize, b: &usize, c: &usize) -> usize {
        self.push(MultiplyAdd(*a, *b, *c))
    }

    fn multiply_subtract(&self, a: &usize, b: &usize, c: &usize) -> usize {
        self.push(MultiplySubtract(*a, *b, *c))
    }

    fn subtract_product(&self, a: &usize, b: &usize, c: &usize) -> usize {
        self.push(SubtractProduct(*a, *b, *c))
    }

    /// Nothing is known of a number before the program runs.
    fn is_zero(&self, _: &usize) -> bool {
        false
    }
}
