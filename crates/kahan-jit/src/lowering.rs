//! A program in the terms of the machine: the same operations, of which fewer kinds are left.
//!
//! In: a program as its caller wrote it. Out: products and sums apart where multiply-adds are not
//! fused, every value once, no operation that no result needs, and a copy where a result is a
//! number that lies in another array.

use kahan_program::Operation::{
    Add, Call, Constant, Multiply, MultiplyAdd, MultiplySubtract, Negate, Subtract, SubtractProduct,
};
use kahan_program::{Builder, Float, Node};

use crate::program::{Called, Input, Instruction, Program};

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
pub(crate) const SIGN: Instruction = Constant(Float::of(-0.0));

/// Returns the program that the machine runs. Where it changes a sign, [`SIGN`] is one of its
/// operations, though no operand.
pub(crate) fn lowered(program: &Program, fuses: bool, ends: Ends) -> Program {
    let mut lowering = Lowering { lowered: Builder::default(), fuses };
    // An operation that no result needs is not written, and has no place.
    let (is_needed, mut places) = (program.needed(), vec![Node(usize::MAX); program.operations.len()]);
    for (index, operation) in program.operations.iter().enumerate() {
        if is_needed[index] {
            places[index] = lowering.write(operation.with_operands(|operand| places[operand.0]));
        }
    }
    let results = program.outputs.iter().enumerate();
    let outputs = results.map(|(i, result)| lowering.result(i, places[result.0], ends)).collect();
    Program { operations: lowering.lowered.operations().to_vec(), outputs }
}

/// A program that is being written for the machine, every operation once.
struct Lowering {
    lowered: Builder<Input, Float, Called>,
    fuses: bool,
}

impl Lowering {
    /// Writes an operation, and returns its place in the lowered program. Its operands must be such
    /// places.
    fn write(&mut self, operation: Instruction) -> Node {
        let operation = match operation {
            Call(Called::Copy, a, _) => return a,
            Negate(a) => match self.lowered.operations()[a.0] {
                Constant(number) => Constant(Float::of(-number.value())),
                _ => {
                    self.lowered.push(SIGN);
                    operation
                }
            },
            MultiplyAdd(a, b, c) if !self.fuses => Add(self.lowered.push(Multiply(a, b)), c),
            MultiplySubtract(a, b, c) if !self.fuses => Subtract(self.lowered.push(Multiply(a, b)), c),
            SubtractProduct(a, b, c) if !self.fuses => Subtract(a, self.lowered.push(Multiply(b, c))),
            _ => operation,
        };
        self.lowered.push(operation)
    }

    /// The place of result `i`; of a number that lies somewhere else, that of a copy.
    fn result(&mut self, i: usize, place: Node, ends: Ends) -> Node {
        let stays = match (self.lowered.operations()[place.0], ends) {
            (Instruction::Input(Input::State(_)), Ends::Carried) => true,
            (Instruction::Input(Input::State(j)), Ends::InPlace) => i == j,
            (operation, _) => !operation.is_given(),
        };
        if stays { place } else { self.lowered.push(Call(Called::Copy, place, place)) }
    }
}
