//! Builds, writes, fuses and joins programs, and runs them over residues modulo 7.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

use crate::{Arithmetic, Builder, Calls, ExactConstant, Function, Node, Operation, Program, cost};

impl ExactConstant for i64 {
    fn one() -> Self {
        1
    }

    fn is(&self, n: i64) -> bool {
        *self == n
    }

    fn is_negative(&self) -> bool {
        *self < 0
    }

    fn negated(&self) -> Self {
        -self
    }

    fn quotient(&self, divisor: &Self) -> Option<Self> {
        (*divisor != 0 && self % divisor == 0).then(|| self / divisor)
    }
}

struct Modulo7;

impl Arithmetic for Modulo7 {
    type Value = i64;
    type Constant = i64;

    fn constant(&self, value: &i64) -> Option<i64> {
        Some(value.rem_euclid(7))
    }

    fn add(&self, a: &i64, b: &i64) -> i64 {
        (a + b) % 7
    }

    fn subtract(&self, a: &i64, b: &i64) -> i64 {
        (a - b).rem_euclid(7)
    }

    fn multiply(&self, a: &i64, b: &i64) -> i64 {
        a * b % 7
    }

    fn negate(&self, a: &i64) -> i64 {
        (7 - a) % 7
    }

    fn divide(&self, a: &i64, b: &i64) -> Option<i64> {
        (1..7).find(|inverse| inverse * b % 7 == 1).map(|inverse| a * inverse % 7)
    }

    fn is_zero(&self, a: &i64) -> bool {
        *a == 0
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Larger {
    OfTwo,
}

impl Function for Larger {
    fn arguments(&self) -> usize {
        2
    }
}

impl fmt::Display for Larger {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("max")
    }
}

impl Calls<Larger> for Modulo7 {
    fn call(&self, _: &Larger, a: &i64, b: &i64) -> Option<i64> {
        Some(*a.max(b))
    }
}

type Plain = Program<Vec<Operation<usize, i64>>>;

fn name(input: &usize) -> String {
    ["x", "y", "z"][*input].to_string()
}

#[test]
fn an_operation_is_written_once_and_signs_move_outwards() {
    let mut builder = Builder::<usize, i64>::default();
    let [x, y] = [0, 1].map(|input| builder.input(input));
    let minus_two = builder.constant(&-2);
    let product = builder.multiply(minus_two, x);
    let other = builder.multiply(x, minus_two);
    assert_eq!(product, other);
    let sum = builder.add(y, product);
    let zero = builder.constant(&0);
    assert_eq!(builder.add(sum, zero), sum);
    let six = builder.constant(&6);
    let three = builder.divide(six, minus_two);
    let result = builder.multiply(sum, three);
    let program = builder.finish(&[result]);
    assert_eq!(program.text(name), "v3 = x*2\nv4 = y - v3\nv6 = v4*3\nv7 = -v6\n");
    assert_eq!(program.uses(), [1, 1, 1, 1, 1, 1, 1, 1]);
}

#[test]
fn a_power_is_repeated_squaring() {
    let mut builder = Builder::<usize, i64>::default();
    let x = builder.input(0);
    let power = builder.power(x, 5);
    assert_eq!(builder.finish(&[power]).text(name), "v1 = x*x\nv2 = v1*v1\nv3 = x*v2\n");
}

fn quotient_and_difference() -> Plain {
    let mut builder = Builder::default();
    let [x, y, z] = [0, 1, 2].map(|input| builder.input(input));
    let quotient = builder.divide(x, y);
    let difference = builder.push(Operation::MultiplySubtract(x, y, z));
    builder.finish(&[quotient, difference])
}

#[test]
fn results_are_those_of_the_arithmetic() {
    let program = quotient_and_difference();
    let mut workspace = [0; 5];
    let mut outputs = [0; 2];
    assert_eq!(program.run(&Modulo7, &[3, 5, 6], &mut workspace, &mut outputs), Some(()));
    // Modulo 7: 3/5 = 2 and 15 − 6 = 2.
    assert_eq!(outputs, [2, 2]);
    assert_eq!(program.run(&Modulo7, &[3, 0, 6], &mut workspace, &mut outputs), None);
    let partly = program.evaluate(&Modulo7, |input| Some([3, 0, 6][*input]));
    assert_eq!(partly, [None, Some(1)]);
    let without_z = program.evaluate(&Modulo7, |input| [Some(3), Some(5), None][*input]);
    assert_eq!(without_z, [Some(2), None]);
}

#[test]
fn a_borrowed_program_has_outputs_of_its_own() {
    let program = quotient_and_difference();
    let only = Program { operations: &program.operations[..], outputs: &[Node(4)][..] };
    let mut outputs = [0];
    assert_eq!(only.run(&Modulo7, &[3, 5, 6], &mut [0; 5], &mut outputs), Some(()));
    assert_eq!(outputs, [2]);
    assert_eq!(program.part(1..2).text(name), "v3 = x*y - z\n");
}

#[test]
fn programs_that_are_joined_share_what_they_compute() {
    let program = quotient_and_difference();
    let both = Program::together([&program, &program.part(0..1)]);
    assert_eq!(both.operations, program.operations);
    assert_eq!(both.outputs, [Node(3), Node(4), Node(3)]);
}

#[test]
fn functions_are_called() {
    let mut builder = Builder::<usize, i64, Larger>::default();
    let [x, y] = [0, 1].map(|input| builder.input(input));
    let larger = builder.push(Operation::Call(Larger::OfTwo, x, y));
    let program = builder.finish(&[larger]);
    assert_eq!(program.text(name), "v2 = max(x, y)\n");
    let mut outputs = [0];
    program.run(&Modulo7, &[3, 5], &mut [0; 3], &mut outputs).expect("a maximum of two numbers");
    assert_eq!(outputs, [5]);
}

#[test]
fn a_product_that_is_added_once_is_fused() {
    let mut builder = Builder::<usize, i64>::default();
    let [x, y, z] = [0, 1, 2].map(|v| builder.input(v));
    let product = builder.multiply(x, y);
    let sum = builder.subtract(z, product);
    let cost = builder.finish(&[sum]).fused().cost();
    assert_eq!((cost.fused, cost.operations(), cost.critical_path), (1, 2, cost::FUSED));
    // A product that is also used elsewhere is not fused.
    let cost = builder.finish(&[sum, product]).fused().cost();
    assert_eq!((cost.fused, cost.operations()), (0, 2));
}

#[test]
fn the_later_of_two_products_is_fused() {
    let mut builder = Builder::<usize, i64>::default();
    let [x, y] = [0, 1].map(|v| builder.input(v));
    let product = builder.multiply(x, y);
    let cube = builder.multiply(product, x);
    let square = builder.multiply(y, y);
    let sum = builder.add(square, cube);
    let cost = builder.finish(&[sum]).fused().cost();
    assert_eq!((cost.fused, cost.operations(), cost.critical_path), (1, 4, 4 + cost::FUSED));
}

#[test]
fn a_late_addend_on_the_chain_is_not_fused() {
    let mut builder = Builder::<usize, i64>::default();
    let [x, y, z] = [0, 1, 2].map(|v| builder.input(v));
    let early = builder.multiply(x, y);
    let late = builder.divide(x, z);
    let sum = builder.add(late, early);
    let plan = builder.finish(&[sum]);
    assert_eq!(plan.clone().fused(), plan);
}
