//! Lowering of programs to machine operations.
//!
//! The lowered program has no duplicate operations, and no unneeded ones except constants. If the
//! code does not fuse multiply-adds, they become two operations. Results that are inputs or
//! constants are copied, unless a state may stay in place.

use kahan_program::Operation::{
    Add, Call, Constant, Multiply, MultiplyAdd, MultiplySubtract, Negate, Subtract, SubtractProduct,
};
use kahan_program::{Builder, Float, Node};

use crate::program::{CalledFunction, Input, Instruction, Program};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ResultDestination {
    /// Result i becomes state i of the next round, and stays in register i.
    Carried,
    InPlace,
    Elsewhere,
}

/// The constant −0. A negation flips the sign bit by xor with this constant.
pub(crate) const SIGN_BIT: Instruction = Constant(Float::of(-0.0));

/// Lowers a program. If the program negates a number, the constant [`SIGN_BIT`] is added.
pub(crate) fn lowered(program: &Program, fuses: bool, ends: ResultDestination) -> Program {
    let mut lowering = Lowering { lowered: Builder::default(), fuses };
    // `places[n]` is the lowered node of operation n, or invalid if operation n is not needed.
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

struct Lowering {
    lowered: Builder<Input, Float, CalledFunction>,
    fuses: bool,
}

impl Lowering {
    fn write(&mut self, operation: Instruction) -> Node {
        let operation = match operation {
            Call(CalledFunction::Copy, a, _) => return a,
            Negate(a) => match self.lowered.operations()[a.0] {
                Constant(number) => Constant(Float::of(-number.value())),
                _ => {
                    self.lowered.push(SIGN_BIT);
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

    /// Returns the node of result `i`. A result that is an input or a constant is copied, unless it
    /// is a state that may stay where it is.
    fn result(&mut self, i: usize, place: Node, ends: ResultDestination) -> Node {
        let stays = match (self.lowered.operations()[place.0], ends) {
            (Instruction::Input(Input::State(_)), ResultDestination::Carried) => true,
            (Instruction::Input(Input::State(j)), ResultDestination::InPlace) => i == j,
            (operation, _) => !operation.is_given(),
        };
        if stays { place } else { self.lowered.push(Call(CalledFunction::Copy, place, place)) }
    }
}
