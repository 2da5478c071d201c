//! Checks machine code against the interpreter bit for bit, on every available instruction set.

use crate::program::Program;
use crate::{ComposedOrbit, Constants, Float, Function, InstructionSet, LaneCount, Orbit, Shape, Sweep};

use super::{Draw, random_program, run, same};

/// Returns the shapes that are available on this machine, and prints the other shapes.
fn shapes(lanes: LaneCount) -> impl Iterator<Item = Shape> {
    InstructionSet::ALL.into_iter().flat_map(move |instructions| {
        if !instructions.is_available() {
            println!("not run: this processor has no {instructions:?}");
        }
        [false, true].map(|fuses| Shape { instructions, lanes, fuses }).into_iter().filter(
            |Shape { instructions, fuses, .. }| {
                instructions.is_available() && (!fuses || instructions.has_fused())
            },
        )
    })
}

trait Tested: Float + num_traits::Float + core::fmt::Debug {
    fn of(value: f64) -> Self;
}

impl Tested for f32 {
    fn of(value: f64) -> Self {
        value as f32
    }
}

impl Tested for f64 {
    fn of(value: f64) -> Self {
        value
    }
}

fn numbers<T: Tested>(draw: &mut Draw, count: usize) -> Vec<T> {
    let ordinary = if draw.below(3) == 0 { 55 } else { 5000 };
    (0..count).map(|_| T::of(draw.number(ordinary))).collect()
}

fn assert_same<T: Tested>(found: &[T], expected: &[T], what: &str, program: &Program) {
    let agree = found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| same(*a, *b));
    assert!(agree, "{what}: {found:?}, not {expected:?}\n{program:?}");
}

/// Draws a program, which is usually small and sometimes long enough to spill many values.
fn draw_program(draw: &mut Draw, case: usize) -> (Program, usize, usize) {
    let (states, constants) = match case % 10 {
        9 => (40, 30),
        _ => (1 + draw.below(7), draw.below(9)),
    };
    let operations = if case % 10 == 9 { 400 } else { 3 + case % 80 };
    (random_program(draw, states, constants, operations), states, constants)
}

fn functions<T: Tested>() {
    let mut draw = Draw(1);
    for case in 0..300 {
        let (program, states, constants) = draw_program(&mut draw, case);
        for shape in shapes(LaneCount::One) {
            let (x, c) = (numbers::<T>(&mut draw, states), numbers::<T>(&mut draw, constants));
            let mut found = vec![T::of(7.0); states];
            Function::compile(&program, shape).expect("it compiles").run(&x, &c, &mut found);
            let expected = run(&program, &x, &c, shape.fuses);
            assert_same(&found, &expected, &format!("case {case}, {shape:?}"), &program);
        }
    }
}

#[test]
fn a_function_computes_its_results() {
    functions::<f64>();
    functions::<f32>();
}

fn lanes_of<T: Tested>() {
    let mut draw = Draw(2);
    for case in 0..200 {
        let (program, states, constants) = draw_program(&mut draw, case);
        for shape in shapes(LaneCount::All) {
            let width = shape.width::<T>();
            let (x, c) =
                (numbers::<T>(&mut draw, states * width), numbers::<T>(&mut draw, constants * width));
            let mut found = vec![T::of(7.0); states * width];
            Function::compile(&program, shape).expect("it compiles").run(&x, &c, &mut found);
            for lane in 0..width {
                let of_lane = |all: &[T]| all.iter().skip(lane).step_by(width).copied().collect::<Vec<T>>();
                let expected = run(&program, &of_lane(&x), &of_lane(&c), shape.fuses);
                assert_same(&of_lane(&found), &expected, &format!("case {case}, {shape:?}"), &program);
            }
        }
    }
}

#[test]
fn each_lane_of_a_function_computes_its_own_results() {
    lanes_of::<f64>();
    lanes_of::<f32>();
}

fn orbits<T: Tested>() {
    let mut draw = Draw(3);
    for case in 0..300 {
        let (program, states, constants) = draw_program(&mut draw, case);
        for shape in shapes(LaneCount::One) {
            let what = format!("case {case}, {shape:?}");
            let fuses = shape.fuses;
            let x = numbers::<T>(&mut draw, states);
            let stages: Vec<Vec<T>> = (0..3).map(|_| numbers(&mut draw, constants)).collect();
            let orbit = Orbit::compile(&program, shape).expect("it compiles");
            let composed = ComposedOrbit::compile(&program, shape).expect("it compiles");
            let mut found = numbers::<T>(&mut draw, states);
            orbit.step(&x, &stages[0], &mut found);
            assert_same(&found, &run(&program, &x, &stages[0], fuses), &what, &program);
            for steps in [0, 1, 2, 5] {
                let mut found = x.clone();
                orbit.run(&mut found, &stages[0], steps);
                let expected = (0..steps).fold(x.clone(), |x, _| run(&program, &x, &stages[0], fuses));
                assert_same(&found, &expected, &what, &program);

                let mut found = x.clone();
                composed.run(&mut found, stages.iter().map(Vec::as_slice), steps);
                let each = (0..steps).flat_map(|_| &stages);
                let expected = each.fold(x.clone(), |x, stage| run(&program, &x, stage, fuses));
                assert_same(&found, &expected, &what, &program);
            }
        }
    }
}

#[test]
fn an_orbit_is_so_many_rounds() {
    orbits::<f64>();
    orbits::<f32>();
}

fn sweeps<T: Tested>() {
    let mut draw = Draw(4);
    for case in 0..150 {
        let (program, states, constants) = draw_program(&mut draw, case);
        for shape in shapes(LaneCount::All).chain(shapes(LaneCount::One)) {
            for of in [Constants::Shared, Constants::Own] {
                let (width, registers) = (shape.width::<T>(), 3);
                let count = width * registers;
                let columns: Vec<Vec<T>> = (0..states).map(|_| numbers(&mut draw, count)).collect();
                let sets = if of == Constants::Own { registers } else { 1 };
                let all = numbers::<T>(&mut draw, sets * constants * width);
                let sweep = Sweep::compile(&program, shape, of).expect("it compiles");
                for steps in [0, 1, 3] {
                    let mut found = columns.clone();
                    let mut slices: Vec<&mut [T]> = found.iter_mut().map(Vec::as_mut_slice).collect();
                    sweep.run(&mut slices, &all, steps);
                    for trajectory in 0..count {
                        let at =
                            |columns: &[Vec<T>]| columns.iter().map(|column| column[trajectory]).collect();
                        let set = if of == Constants::Own { trajectory / width } else { 0 };
                        let own = &all[set * constants * width..][..constants * width];
                        let own: Vec<T> =
                            own.iter().skip(trajectory % width).step_by(width).copied().collect();
                        let start: Vec<T> = at(&columns);
                        let fuses = shape.fuses;
                        let expected = (0..steps).fold(start, |x, _| run(&program, &x, &own, fuses));
                        let found: Vec<T> = at(&found);
                        let what =
                            format!("case {case}, {shape:?}, {of:?}, {steps} steps, trajectory {trajectory}");
                        assert_same(&found, &expected, &what, &program);
                    }
                }
            }
        }
    }
}

#[test]
fn a_sweep_advances_each_trajectory() {
    sweeps::<f64>();
    sweeps::<f32>();
}

/// On 64-bit Arm, long code uses other jump and load instructions than short code.
#[test]
fn long_code_computes_its_results() {
    let program = random_program(&mut Draw(7), 3, 2, 24_000);
    let (x, c) = ([0.5, -0.25, 1.5], [0.125, -2.0]);
    for shape in shapes(LaneCount::One) {
        let expected = (0..3).fold(x.to_vec(), |x, _| run(&program, &x, &c, shape.fuses));
        let mut found = x;
        Orbit::compile(&program, shape).expect("it compiles").run(&mut found, &c, 3);
        assert_same(&found, &expected, &format!("{shape:?}"), &program);
        let mut columns = x.map(|number| vec![number; 2]);
        Sweep::compile(&program, shape, Constants::Shared).expect("it compiles").run(&mut columns, &c, 3);
        assert_same(&columns.map(|column| column[1]), &expected, &format!("{shape:?}"), &program);
    }
}

fn small() -> Program {
    random_program(&mut Draw(5), 3, 2, 20)
}

const SCALAR: Shape =
    Shape { instructions: InstructionSet::least(false), lanes: LaneCount::One, fuses: false };

#[test]
#[should_panic(expected = "3 states")]
fn code_is_not_entered_with_too_few_states() {
    if !SCALAR.instructions.is_available() {
        panic!("3 states, and no code");
    }
    Orbit::compile(&small(), SCALAR).expect("it compiles").run(&mut [1.0, 2.0], &[1.0, 2.0], 1);
}

#[test]
fn what_an_instruction_set_lacks_is_refused() {
    let avx = Shape { instructions: InstructionSet::Avx, fuses: true, ..SCALAR };
    let refusal = Orbit::<f64>::compile(&small(), avx).expect_err("AVX fuses nothing");
    assert!(refusal.to_string().contains("no multiply-adds"), "{refusal}");
}

#[test]
fn a_program_beyond_the_budget_is_refused() {
    let program = random_program(&mut Draw(6), 3, 2, 60_000);
    let refusal = Function::<f64>::compile(&program, SCALAR).expect_err("it is too long").to_string();
    assert!(!SCALAR.instructions.is_available() || refusal.contains("too long"), "{refusal}");
}
