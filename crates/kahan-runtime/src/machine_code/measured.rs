//! For each system of the catalog, prints the size of a step's machine code, and Rust source with
//! the same operations, which the script `arm/steps` compiles for comparison.

use std::fmt::Write;

use kahan_dynamics::Precision;
use kahan_jit::{Input, InstructionSet, LaneCount, Orbit, Program, Shape};
use kahan_program::{Node, Operation};
use kahan_systems::registry::all;

use crate::Field;

use super::StepKind;

/// Returns the source of a Rust function that runs a program repeatedly on its own results.
fn in_rust(name: &str, program: &Program, states: usize) -> String {
    let product = |a: Node, b: Node| format!("v{} * v{}", a.0, b.0);
    let mut lines = String::new();
    let mut constants = 0;
    for (place, operation) in program.operations.iter().enumerate() {
        let value = match *operation {
            Operation::Input(Input::State(i)) => format!("x[{i}]"),
            Operation::Input(Input::Constant(k)) => {
                constants = constants.max(k + 1);
                format!("c[{k}]")
            }
            Operation::Constant(number) => format!("{:?}_f64", number.value()),
            Operation::Add(a, b) => format!("v{} + v{}", a.0, b.0),
            Operation::Subtract(a, b) => format!("v{} - v{}", a.0, b.0),
            Operation::Multiply(a, b) => product(a, b),
            Operation::Divide(a, b) => format!("v{} / v{}", a.0, b.0),
            Operation::Negate(a) => format!("-v{}", a.0),
            Operation::MultiplyAdd(a, b, c) => format!("{} + v{}", product(a, b), c.0),
            Operation::MultiplySubtract(a, b, c) => format!("{} - v{}", product(a, b), c.0),
            Operation::SubtractProduct(a, b, c) => format!("v{} - {}", a.0, product(b, c)),
            Operation::Call(called, ..) => panic!("no operation of a plan is {called:?}"),
        };
        writeln!(lines, "        let v{place} = {value};").expect("a text grows");
    }
    let results: Vec<String> = program.outputs.iter().map(|node| format!("v{}", node.0)).collect();
    let arguments = format!("state: &mut [f64; {states}], c: &[f64; {constants}], steps: u64");
    let before = "let (mut x, c) = (*state, *c);\n    for _ in 0..steps {";
    let after = format!("x = [{}];\n    }}\n    *state = x;", results.join(", "));
    format!("#[unsafe(no_mangle)]\npub fn {name}({arguments}) {{\n    {before}\n{lines}        {after}\n}}\n")
}

#[test]
#[ignore = "`arm/steps` reads what it prints"]
fn instructions_of_a_step() {
    for entry in all() {
        let engine = Field::parse(entry.text()).expect("a field").engine;
        let program = StepKind::of(Precision::Double, false).program::<f64>(&engine).expect("short");
        let instructions = InstructionSet::least(false);
        let shape = Shape { instructions, lanes: LaneCount::One, fuses: false };
        let orbit = Orbit::<f64>::compile(&program, shape).expect("it compiles");
        assert!(orbit.round_bytes() >= 4 * program.outputs.len(), "{}", entry.command);
        let name = entry.command.replace('-', "_");
        println!("// {name} {}", orbit.round_bytes());
        println!("{}", in_rust(&name, &program, engine.dimension()));
    }
}
