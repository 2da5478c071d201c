//! What a program computes, one operation at a time: what code and allocation are compared with.

use std::sync::LazyLock;

use num_traits::Float;

use crate::{Instruction, Program};
use Instruction::*;

/// The results of a program as a processor computes them.
pub(crate) fn run<T: Float>(program: &Program, states: &[T], constants: &[T], fuses: bool) -> Vec<T> {
    run_by(program, |i| states[i], |k| constants[k], fuses)
}

/// The same of states and constants wherever they are.
pub(crate) fn run_by<T: Float>(
    program: &Program,
    state: impl Fn(usize) -> T,
    constant: impl Fn(usize) -> T,
    fuses: bool,
) -> Vec<T> {
    let multiply_add = |a: T, b: T, c: T| if fuses { a.mul_add(b, c) } else { a * b + c };
    let number = |value: f64| T::from(value).expect("floats have every number");
    let last = program.results().iter().max();
    let mut values: Vec<T> = Vec::new();
    for index in 0..last.map_or(0, |last| last + 1) {
        values.push(match program.instruction(index) {
            State(i) => state(i),
            Constant(k) => constant(k),
            Literal(bits) => number(f64::from_bits(bits)),
            Add(a, b) => values[a] + values[b],
            Subtract(a, b) => values[a] - values[b],
            Multiply(a, b) => values[a] * values[b],
            Divide(a, b) => values[a] / values[b],
            Maximum(a, b) if values[a] > values[b] => values[a],
            Minimum(a, b) if values[a] < values[b] => values[a],
            Maximum(_, b) | Minimum(_, b) => values[b],
            Negate(a) => -values[a],
            MultiplyAdd(a, b, c) => multiply_add(values[a], values[b], values[c]),
            MultiplySubtract(a, b, c) => multiply_add(values[a], values[b], -values[c]),
            SubtractProduct(a, b, c) if fuses => subtract_product(values[a], values[b], values[c]),
            SubtractProduct(a, b, c) => values[a] - values[b] * values[c],
            Copy(a) => values[a],
            RoundToSingle(a) => number(f64::from(values[a].to_f32().expect("floats round"))),
        });
    }
    program.results().iter().map(|result| values[*result]).collect()
}

/// a − b·c, rounded once. Valgrind computes −(b·c − a) instead, whose zeros have the other sign.
pub(crate) fn subtract_product<T: Float>(a: T, b: T, c: T) -> T {
    static IS_VALGRIND: LazyLock<bool> =
        LazyLock::new(|| std::env::var("LD_PRELOAD").is_ok_and(|loaded| loaded.contains("/valgrind/")));

    if *IS_VALGRIND { -b.mul_add(c, -a) } else { (-b).mul_add(c, a) }
}

/// Whether two numbers have the same bits, any two that are none being the same.
pub(crate) fn same<T: Float>(a: T, b: T) -> bool {
    (a.is_nan() && b.is_nan()) || a.integer_decode() == b.integer_decode()
}
