//! The reference interpreter of programs.

use std::sync::LazyLock;

use num_traits::Float;

use kahan_program::Node;
use kahan_program::Operation::*;

use crate::{CalledFunction, Program};

pub(crate) fn run<T: Float>(program: &Program, states: &[T], constants: &[T], fuses: bool) -> Vec<T> {
    run_by(program, |i| states[i], |k| constants[k], fuses)
}

pub(crate) fn run_by<T: Float>(
    program: &Program,
    state: impl Fn(usize) -> T,
    constant: impl Fn(usize) -> T,
    fuses: bool,
) -> Vec<T> {
    let multiply_add = |a: T, b: T, c: T| if fuses { a.mul_add(b, c) } else { a * b + c };
    let number = |value: f64| T::from(value).expect("floats have every number");
    let last = program.outputs.iter().max();
    let mut values: Vec<T> = Vec::new();
    for operation in &program.operations[..last.map_or(0, |last| last.0 + 1)] {
        let at = |node: Node| values[node.0];
        values.push(match *operation {
            Input(crate::Input::State(i)) => state(i),
            Input(crate::Input::Constant(k)) => constant(k),
            Constant(literal) => number(literal.value()),
            Add(a, b) => at(a) + at(b),
            Subtract(a, b) => at(a) - at(b),
            Multiply(a, b) => at(a) * at(b),
            Divide(a, b) => at(a) / at(b),
            Call(CalledFunction::Maximum, a, b) if at(a) > at(b) => at(a),
            Call(CalledFunction::Minimum, a, b) if at(a) < at(b) => at(a),
            Call(CalledFunction::Maximum | CalledFunction::Minimum, _, b) => at(b),
            Negate(a) => -at(a),
            MultiplyAdd(a, b, c) => multiply_add(at(a), at(b), at(c)),
            MultiplySubtract(a, b, c) => multiply_add(at(a), at(b), -at(c)),
            SubtractProduct(a, b, c) if fuses => subtract_product(at(a), at(b), at(c)),
            SubtractProduct(a, b, c) => at(a) - at(b) * at(c),
            Call(CalledFunction::Copy, a, _) => at(a),
            Call(CalledFunction::RoundToSingle, a, _) => {
                number(f64::from(at(a).to_f32().expect("floats round")))
            }
        });
    }
    program.outputs.iter().map(|result| values[result.0]).collect()
}

pub(crate) fn read(program: &Program) -> [usize; 2] {
    let end = |of: fn(crate::Input) -> Option<usize>| {
        let ends = program.inputs().into_iter().filter_map(of).map(|entry| entry.saturating_add(1));
        ends.max().unwrap_or(0)
    };
    let states = end(|input| if let crate::Input::State(i) = input { Some(i) } else { None });
    let constants = end(|input| if let crate::Input::Constant(k) = input { Some(k) } else { None });
    [states, constants]
}

/// Returns a − b·c, rounded once. Valgrind gives a zero result the wrong sign. Under Valgrind this
/// function does so too, because tests compare it with machine code.
pub(crate) fn subtract_product<T: Float>(a: T, b: T, c: T) -> T {
    static IS_VALGRIND: LazyLock<bool> =
        LazyLock::new(|| std::env::var("LD_PRELOAD").is_ok_and(|loaded| loaded.contains("/valgrind/")));

    if *IS_VALGRIND { -b.mul_add(c, -a) } else { (-b).mul_add(c, a) }
}

/// Returns whether two numbers have equal bits or are both NaN.
pub(crate) fn same<T: Float>(a: T, b: T) -> bool {
    (a.is_nan() && b.is_nan()) || a.integer_decode() == b.integer_decode()
}
