//! A program in the terms of the machine: the same instructions, of which fewer kinds are left.
//!
//! In: a program as its caller wrote it. Out: products and sums apart where multiply-adds are not
//! fused, every value once, no instruction that no result needs, and a copy where a result is a
//! number that lies in another array.

use rustc_hash::FxHashMap;

use crate::program::{Instruction, Program};

use Instruction::{
    Add, Constant, Copy, Literal, Multiply, MultiplyAdd, MultiplySubtract, Negate, State, Subtract,
    SubtractProduct,
};

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

/// The number whose only bit is the sign: to change a sign is to flip that bit.
pub(crate) const SIGN: Instruction = Literal((-0.0_f64).to_bits());

impl Program {
    /// The program that the machine runs. Where it changes a sign, [`SIGN`] is one of its
    /// instructions.
    pub(crate) fn lowered(&self, fuses: bool, ends: Ends) -> Self {
        let mut lowering = Lowering { lowered: Program::default(), known: FxHashMap::default(), fuses };
        // An instruction that no result needs is not written, and has no place.
        let (is_needed, mut places) = (self.needed(), vec![usize::MAX; self.instructions.len()]);
        for (index, instruction) in self.instructions.iter().enumerate() {
            if is_needed[index] {
                places[index] = lowering.write(instruction.with_operands(|operand| places[operand]));
            }
        }
        let results = self.results.iter().enumerate();
        let results = results.map(|(i, result)| lowering.result(i, places[*result], ends)).collect();
        Program { results, ..lowering.lowered }
    }

    /// Whether each instruction is needed for a result.
    fn needed(&self) -> Vec<bool> {
        let mut needed = vec![false; self.instructions.len()];
        self.results.iter().for_each(|result| needed[*result] = true);
        for (index, instruction) in self.instructions.iter().enumerate().rev() {
            if needed[index] {
                instruction.operands().for_each(|operand| needed[operand] = true);
            }
        }
        needed
    }
}

/// A program that is being written for the machine.
struct Lowering {
    lowered: Program,
    /// The place of every instruction that was written.
    known: FxHashMap<Instruction, usize>,
    fuses: bool,
}

impl Lowering {
    /// Writes an instruction, unless it is there already, and returns its place in the lowered
    /// program. Its operands must be such places.
    fn write(&mut self, instruction: Instruction) -> usize {
        match instruction {
            Copy(a) => a,
            Negate(a) => match self.lowered.instructions[a] {
                Literal(bits) => self.push(Instruction::literal(-f64::from_bits(bits))),
                _ => {
                    self.push(SIGN);
                    self.push(Negate(a))
                }
            },
            MultiplyAdd(a, b, c) if !self.fuses => {
                let product = self.push(Multiply(a, b));
                self.push(Add(product, c))
            }
            MultiplySubtract(a, b, c) if !self.fuses => {
                let product = self.push(Multiply(a, b));
                self.push(Subtract(product, c))
            }
            SubtractProduct(a, b, c) if !self.fuses => {
                let product = self.push(Multiply(b, c));
                self.push(Subtract(a, product))
            }
            _ => self.push(instruction),
        }
    }

    fn push(&mut self, instruction: Instruction) -> usize {
        *self.known.entry(instruction).or_insert_with(|| self.lowered.push(instruction))
    }

    /// The place of result `i`; of a number that lies somewhere else, that of a copy.
    fn result(&mut self, i: usize, place: usize, ends: Ends) -> usize {
        let stays = match (self.lowered.instructions[place], ends) {
            (State(_), Ends::Carried) => true,
            (State(j), Ends::InPlace) => i == j,
            (State(_) | Constant(_) | Literal(_), _) => false,
            _ => true,
        };
        if stays { place } else { self.push(Copy(place)) }
    }
}
