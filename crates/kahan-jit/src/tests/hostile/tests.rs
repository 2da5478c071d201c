//! Tests hostile programs from seeds, and slices that are one number too short.

use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::guarded::{Edge, Guarded};
use super::{Case, Draw, Routine, constant, push, state};
use crate::{
    ComposedOrbit, Constants, Function, Instruction, InstructionSet, LaneCount, Orbit, Program, Shape, Sweep,
};

#[test]
fn hostile_programs_are_refused_or_run_within_their_slices() {
    let (mut draw, mut ran) = (Draw(35), HashMap::new());
    for _ in 0..2000 {
        let length = 8 + draw.below(180);
        let bytes: Vec<u8> = (0..length).map(|_| draw.next() as u8).collect();
        let case = Case::of(&bytes);
        if case.has_run() {
            *ran.entry((case.shape.instructions, case.routine)).or_insert(0) += 1;
        }
    }
    for set in InstructionSet::ALL {
        for routine in Routine::ALL {
            let count = ran.get(&(set, routine)).copied().unwrap_or(0);
            assert!(!set.is_available() || count > 5, "{set:?}, {routine:?}: {count} cases have run");
        }
    }
}

const SHAPE: Shape =
    Shape { instructions: InstructionSet::least(false), lanes: LaneCount::All, fuses: false };

fn small() -> Program {
    let mut program = Program::default();
    let x = push(&mut program, state(1));
    let c = push(&mut program, constant(2));
    let sum = push(&mut program, Instruction::Add(x, c));
    program.outputs = vec![sum, x];
    program
}

fn is_refused(call: impl FnOnce()) -> bool {
    catch_unwind(AssertUnwindSafe(call)).is_err()
}

/// Each array in turn has one number less than the code requires.
#[test]
fn slices_that_are_too_short_stop_before_the_code() {
    if !SHAPE.instructions.is_available() {
        return println!("not run: this processor has no {:?}", SHAPE.instructions);
    }
    let (program, width) = (small(), SHAPE.width::<f64>());
    let slice = |count: usize| Guarded::<f64>::zeros(count, Edge::End);
    let lengths = [2 * width, 3 * width, 2 * width];
    let shortened = || {
        (0..lengths.len()).map(|short| {
            let mut lengths = lengths;
            lengths[short] -= 1;
            lengths.map(slice)
        })
    };

    let function = Function::<f64>::compile(&program, SHAPE).expect("it compiles");
    let orbit = Orbit::<f64>::compile(&program, SHAPE).expect("it compiles");
    let composed = ComposedOrbit::<f64>::compile(&program, SHAPE).expect("it compiles");
    let [states, constants, mut results] = lengths.map(slice);
    function.run(&states, &constants, &mut results);
    orbit.step(&states, &constants, &mut results);
    composed.run(&mut results, [&*constants, &*constants].into_iter(), 1);
    for [mut states, constants, mut results] in shortened() {
        assert!(is_refused(|| function.run(&states, &constants, &mut results)));
        assert!(is_refused(|| orbit.step(&states, &constants, &mut results)));
        if results.len() == lengths[2] {
            assert!(is_refused(|| orbit.run(&mut states, &constants, 1)));
            assert!(is_refused(|| composed.run(
                &mut states,
                [&*slice(lengths[1]), &*constants].into_iter(),
                1
            )));
        }
    }
    assert!(is_refused(|| composed.run(&mut results, [].into_iter(), 1)));

    for of in [Constants::Shared, Constants::Own] {
        let sweep = Sweep::<f64>::compile(&program, SHAPE, of).expect("it compiles");
        let sets = if of == Constants::Own { 2 } else { 1 };
        let needed = sets * 3 * width;
        let columns = |lengths: &[usize]| lengths.iter().map(|len| slice(*len)).collect::<Vec<_>>();
        let good = [2 * width; 2];
        sweep.run(&mut columns(&good), &slice(needed), 1);
        for (lengths, constants) in [
            (&good[..1], needed),
            (&[2 * width, 2 * width - 1], needed),
            (&[2 * width - 1, 2 * width], needed),
            (&[2 * width - 1; 2], needed),
            (&[2 * width, width], needed),
            (&good[..], needed - 1),
            (&[4 * width; 257], 2 * needed),
        ] {
            assert!(is_refused(|| sweep.run(&mut columns(lengths), &slice(constants), 1)), "{lengths:?}");
        }
    }
}
