//! Programs drawn at random, and what they compute: what allocation and code are compared with.

mod allocation;
mod code;
mod draw;

pub(crate) use draw::{Draw, random_program};

use num_traits::Float;

use crate::program::{Instruction, Program};
use Instruction::*;

/// The results of a program as a processor computes them, one operation at a time.
pub(crate) fn run<T: Float>(program: &Program, states: &[T], constants: &[T], fuses: bool) -> Vec<T> {
    let mut values: Vec<T> = Vec::with_capacity(program.instructions.len());
    let multiply_add = |a: T, b: T, c: T| if fuses { a.mul_add(b, c) } else { a * b + c };
    let number = |value: f64| T::from(value).expect("floats have every number");
    for instruction in &program.instructions {
        values.push(match *instruction {
            State(i) => states[i],
            Constant(k) => constants[k],
            Literal(value) => number(value),
            Add(a, b) => values[a] + values[b],
            Subtract(a, b) => values[a] - values[b],
            Multiply(a, b) => values[a] * values[b],
            Divide(a, b) => values[a] / values[b],
            Negate(a) => -values[a],
            MultiplyAdd(a, b, c) => multiply_add(values[a], values[b], values[c]),
            MultiplySubtract(a, b, c) => multiply_add(values[a], values[b], -values[c]),
            SubtractProduct(a, b, c) => multiply_add(-values[b], values[c], values[a]),
            Copy(a) => values[a],
            RoundToSingle(a) => number(f64::from(values[a].to_f32().expect("floats round"))),
        });
    }
    program.results.iter().map(|result| values[*result]).collect()
}

/// Whether two numbers have the same bits, any two that are none being the same.
pub(crate) fn same<T: Float>(a: T, b: T) -> bool {
    (a.is_nan() && b.is_nan()) || a.integer_decode() == b.integer_decode()
}
