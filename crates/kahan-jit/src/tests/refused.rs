//! Tests which programs are refused, and that the code of all others fits the stack of a thread.

use kahan_program::Node;

use crate::{
    CalledFunction, CompileError, ComposedOrbit, Constants, Function, Instruction, InstructionSet, LaneCount,
    Orbit, Program, Shape, Sweep,
};

use super::draw::{constant, literal, push, state};
#[cfg(target_os = "linux")]
use super::starts_itself;

const SHAPE: Shape =
    Shape { instructions: InstructionSet::least(false), lanes: LaneCount::One, fuses: false };

fn is_unavailable() -> bool {
    let is_unavailable = !SHAPE.instructions.is_available();
    if is_unavailable {
        println!("not run: this processor has no {:?}", SHAPE.instructions);
    }
    is_unavailable
}

fn program(operations: &[Instruction], outputs: Vec<Node>) -> Program {
    Program { operations: operations.to_vec(), outputs }
}

/// Offsets from the start of an array must fit signed 32-bit numbers.
#[test]
fn entries_beyond_the_reach_of_an_instruction_are_refused() {
    if is_unavailable() {
        return;
    }
    for entry in [usize::MAX, usize::MAX - 1, 1 << 61, 1 << 60, 1 << 32, 1 << 29, 1 << 28] {
        for instruction in [state(entry), constant(entry)] {
            let program = program(&[instruction, literal(1.0)], vec![Node(0)]);
            let refusal = Function::<f64>::compile(&program, SHAPE).expect_err("no code reaches it");
            assert!(
                matches!(refusal, CompileError::OutOfReach { entries } if entries == entry.saturating_add(1)),
                "{refusal:?}"
            );
        }
        let program = program(&[constant(entry)], vec![Node(0)]);
        let orbit = Orbit::<f64>::compile(&program, SHAPE).expect_err("no code reaches it");
        assert!(matches!(orbit, CompileError::OutOfReach { .. }), "{orbit:?}");
        for of in [Constants::Shared, Constants::Own] {
            let sweep = Sweep::<f64>::compile(&program, SHAPE, of).expect_err("no code reaches it");
            assert!(matches!(sweep, CompileError::OutOfReach { .. }), "{sweep:?}");
        }
    }
    let last = program(&[state((1 << 28) - 2)], vec![Node(0)]);
    assert!(Function::<f64>::compile(&last, SHAPE).is_ok(), "its last byte is in reach");
}

#[test]
fn more_results_than_a_straight_line_has_are_refused() {
    let many = program(&[literal(1.0)], vec![Node(0); 50_001]);
    let refusal = Function::<f64>::compile(&many, SHAPE).expect_err("it is too long");
    assert!(
        is_unavailable() || matches!(refusal, CompileError::TooLong { instructions: 50_001 }),
        "{refusal:?}"
    );
}

#[test]
fn programs_that_read_what_was_not_computed_are_refused() {
    let x = Node(0);
    let reads = [
        (Instruction::Negate(Node(1)), x),
        (Instruction::Add(x, Node(2)), x),
        (Instruction::MultiplyAdd(x, x, Node(usize::MAX)), x),
        (Instruction::Call(CalledFunction::Maximum, x, Node(1)), x),
        (Instruction::Call(CalledFunction::RoundToSingle, Node(1), Node(1)), x),
        (Instruction::Call(CalledFunction::Copy, x, Node(1)), Node(1)),
        (Instruction::Call(CalledFunction::RoundToSingle, x, Node(usize::MAX)), Node(1)),
        (Instruction::Negate(x), Node(2)),
    ];
    for (operation, result) in reads {
        let program = program(&[state(0), operation], vec![result]);
        let refusals = [
            Function::<f64>::compile(&program, SHAPE).expect_err("it reads what is not there"),
            Orbit::<f64>::compile(&program, SHAPE).expect_err("it reads what is not there"),
            ComposedOrbit::<f64>::compile(&program, SHAPE).expect_err("it reads what is not there"),
            Sweep::<f64>::compile(&program, SHAPE, Constants::Own).expect_err("it reads what is not there"),
        ];
        let are_refused = refusals.iter().all(|refusal| matches!(refusal, CompileError::Malformed));
        assert!(is_unavailable() || are_refused, "{operation:?}: {refusals:?}");
    }
}

#[cfg(feature = "pages")]
#[test]
#[should_panic(expected = "a state that is read has a result")]
fn a_round_has_a_result_for_each_state() {
    let _ = Orbit::<f64>::compile(&program(&[state(14)], vec![Node(0)]), SHAPE);
}

fn wide(values: usize) -> Program {
    let mut program = Program::default();
    let mut last = push(&mut program, state(0));
    let values: Vec<Node> = (0..values)
        .map(|_| {
            last = push(&mut program, Instruction::Divide(last, last));
            last
        })
        .collect();
    for pair in values.rchunks_exact(2).rev() {
        last = push(&mut program, Instruction::MultiplyAdd(pair[0], pair[1], last));
    }
    program.outputs = vec![last];
    program
}

const WIDEST: usize = 13_330;

fn run_widest(stack: usize) -> Option<f64> {
    let shape = Shape { instructions: InstructionSet::best()?, lanes: LaneCount::All, fuses: false };
    let run = move || {
        let width = shape.width::<f64>();
        let function = Function::<f64>::compile(&wide(WIDEST), shape).expect("it compiles");
        let mut result = vec![0.0; width];
        function.run(&vec![2.0; width], &[], &mut result);
        result[width - 1]
    };
    let thread = std::thread::Builder::new().stack_size(stack).spawn(run).expect("there is room");
    Some(thread.join().expect("it has room"))
}

#[test]
fn every_program_fits_on_the_stack_of_a_thread() {
    if let Some(result) = run_widest(2 << 20) {
        assert_eq!(result, 1.0 + WIDEST as f64 / 2.0);
    }
}

#[test]
fn more_numbers_at_once_than_the_stack_holds_are_refused() {
    let Some(instructions) = InstructionSet::best() else { return };
    for lanes in [LaneCount::One, LaneCount::All] {
        let shape = Shape { instructions, lanes, fuses: false };
        let program = wide(2 * WIDEST - 10);
        let code = Function::<f64>::compile(&program, shape);
        let fits = shape.width::<f64>() * size_of::<f64>() * 2 * WIDEST < 1 << 20;
        assert!(code.is_ok() == fits || !cfg!(feature = "pages"), "{lanes:?}");
    }
}

/// Runs this test again in a process that must die at the first inaccessible page of the stack.
#[cfg(target_os = "linux")]
#[test]
fn a_stack_that_is_too_small_stops_the_process() {
    const SMALL: &str = "KAHAN_JIT_SMALL_STACK";

    if InstructionSet::best().is_none() {
        return;
    }
    if std::env::var_os(SMALL).is_some() {
        run_widest(128 << 10);
        return;
    }
    if !starts_itself() {
        return;
    }
    let again = std::process::Command::new(std::env::current_exe().expect("this program has a name"))
        .args(["--exact", "tests::refused::a_stack_that_is_too_small_stops_the_process", "--nocapture"])
        .env(SMALL, "1")
        .output()
        .expect("this program runs");
    let said = String::from_utf8_lossy(&again.stderr);
    assert!(!again.status.success() && said.contains("overflowed its stack"), "{said}");
}
