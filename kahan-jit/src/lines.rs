//! A program in the terms of the machine: products and sums apart where multiply-adds are not
//! fused, a change of sign as a flipped bit, numbers and inputs once each, nothing that no result
//! needs.

use std::collections::HashMap;
use std::hash::Hash;

use crate::assembler::{Binary, Fused};
use crate::program::{Instruction, Program};

/// What one line computes; operands are the indices of earlier lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Line {
    /// What is in memory before the first line.
    Given(Given),
    /// a ∘ b
    Binary(Binary, usize, usize),
    /// a·b and c
    Fused(Fused, [usize; 3]),
    /// a in a register or a slot of its own
    Copy(usize),
    /// a rounded to single precision
    RoundToSingle(usize),
}

/// What is in memory before the first line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Given {
    State(usize),
    Constant(usize),
    /// The bits of a number in double precision.
    Literal(u64),
}

/// What becomes of the results of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ends {
    /// Result i is state i of the next round, in register i.
    Carried,
    /// Result i is stored where state i was.
    InPlace,
    /// Results are stored in an array of their own.
    Elsewhere,
}

/// Lines with results.
#[derive(Clone, Debug)]
pub(crate) struct Lines {
    pub(crate) lines: Vec<Line>,
    pub(crate) results: Vec<usize>,
}

impl Line {
    /// The operands in order.
    pub(crate) fn operands(&self) -> impl Iterator<Item = usize> + use<> {
        let operands = match *self {
            Line::Given(_) => [None, None, None],
            Line::Copy(a) | Line::RoundToSingle(a) => [Some(a), None, None],
            Line::Binary(_, a, b) => [Some(a), Some(b), None],
            Line::Fused(_, [a, b, c]) => [Some(a), Some(b), Some(c)],
        };
        operands.into_iter().flatten()
    }
}

impl Lines {
    pub(crate) fn of(program: &Program, fuses: bool, ends: Ends) -> Self {
        let mut writer = Writer { lines: Vec::new(), known: HashMap::new(), fuses };
        let needed = needed(program);
        let mut places: Vec<usize> = Vec::with_capacity(program.instructions.len());
        for (instruction, is_needed) in program.instructions.iter().zip(needed) {
            // What is not needed has no line, and nobody asks for its place.
            places.push(if is_needed { writer.write(instruction, &places) } else { usize::MAX });
        }
        let results = program.results.iter().enumerate();
        let results = results.map(|(i, result)| writer.result(i, places[*result], ends)).collect();
        Lines { lines: writer.lines, results }
    }
}

/// Whether each instruction is needed for a result.
fn needed(program: &Program) -> Vec<bool> {
    let mut needed = vec![false; program.instructions.len()];
    program.results.iter().for_each(|result| needed[*result] = true);
    for (index, instruction) in program.instructions.iter().enumerate().rev() {
        if needed[index] {
            instruction.operands().for_each(|operand| needed[operand] = true);
        }
    }
    needed
}

struct Writer {
    lines: Vec<Line>,
    known: HashMap<Line, usize>,
    fuses: bool,
}

impl Writer {
    fn write(&mut self, instruction: &Instruction, places: &[usize]) -> usize {
        match *instruction {
            Instruction::State(i) => self.push(Line::Given(Given::State(i))),
            Instruction::Constant(k) => self.push(Line::Given(Given::Constant(k))),
            Instruction::Literal(value) => self.literal(value),
            Instruction::Add(a, b) => self.binary(Binary::Add, places[a], places[b]),
            Instruction::Subtract(a, b) => self.binary(Binary::Subtract, places[a], places[b]),
            Instruction::Multiply(a, b) => self.binary(Binary::Multiply, places[a], places[b]),
            Instruction::Divide(a, b) => self.binary(Binary::Divide, places[a], places[b]),
            Instruction::Negate(a) => match self.lines[places[a]] {
                Line::Given(Given::Literal(bits)) => self.literal(-f64::from_bits(bits)),
                _ => {
                    let sign = self.literal(-0.0);
                    self.binary(Binary::ExclusiveOr, places[a], sign)
                }
            },
            Instruction::MultiplyAdd(a, b, c) => {
                self.fused(Fused::MultiplyAdd, [places[a], places[b], places[c]])
            }
            Instruction::MultiplySubtract(a, b, c) => {
                self.fused(Fused::MultiplySubtract, [places[a], places[b], places[c]])
            }
            Instruction::SubtractProduct(a, b, c) => {
                self.fused(Fused::SubtractProduct, [places[b], places[c], places[a]])
            }
            Instruction::Copy(a) => places[a],
            Instruction::RoundToSingle(a) => self.push(Line::RoundToSingle(places[a])),
        }
    }

    fn push(&mut self, line: Line) -> usize {
        *self.known.entry(line).or_insert_with(|| {
            self.lines.push(line);
            self.lines.len() - 1
        })
    }

    fn literal(&mut self, value: f64) -> usize {
        self.push(Line::Given(Given::Literal(value.to_bits())))
    }

    fn binary(&mut self, operator: Binary, a: usize, b: usize) -> usize {
        self.push(Line::Binary(operator, a, b))
    }

    /// One line, or a product and what is done with it.
    fn fused(&mut self, operator: Fused, [a, b, c]: [usize; 3]) -> usize {
        if self.fuses {
            return self.push(Line::Fused(operator, [a, b, c]));
        }
        let product = self.binary(Binary::Multiply, a, b);
        match operator {
            Fused::MultiplyAdd => self.binary(Binary::Add, product, c),
            Fused::MultiplySubtract => self.binary(Binary::Subtract, product, c),
            Fused::SubtractProduct => self.binary(Binary::Subtract, c, product),
        }
    }

    /// Result `i`; where it is something given that is not in its place, a copy of that.
    fn result(&mut self, i: usize, line: usize, ends: Ends) -> usize {
        let Line::Given(given) = self.lines[line] else { return line };
        let stays = match (ends, given) {
            (Ends::Carried, Given::State(_)) => true,
            (Ends::InPlace, Given::State(j)) => i == j,
            _ => false,
        };
        if stays { line } else { self.push(Line::Copy(line)) }
    }
}
