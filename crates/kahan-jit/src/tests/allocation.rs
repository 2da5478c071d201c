//! Checks that allocated code computes the program's results, with any number of registers.

use std::collections::HashMap;

use crate::allocation::{Allocation, FEWEST_REGISTERS, MachineInstruction, RoundPlan, ValueLocation};
use crate::assembler::{Binary, Fused, FusedOrder, Source, Vector};
use crate::lowering::{ResultDestination, lowered};
use crate::program::{Instruction, Program};

use super::draw::{push, state};
use super::{Draw, random_program, run, same, subtract_product};

struct Machine {
    registers: Vec<Option<f64>>,
    memory: HashMap<ValueLocation, f64>,
}

impl Machine {
    fn at(&self, place: ValueLocation) -> f64 {
        match place {
            ValueLocation::Literal(number) => number.value(),
            _ => *self.memory.get(&place).expect("what is read was written"),
        }
    }

    fn register(&self, register: Vector) -> f64 {
        self.registers[usize::from(register.0)].expect("a register is read after it is written")
    }

    fn operand(&self, operand: Source<ValueLocation>) -> f64 {
        match operand {
            Source::Register(register) => self.register(register),
            Source::Memory(place) => self.at(place),
        }
    }

    fn run(&mut self, instructions: &[MachineInstruction]) {
        for instruction in instructions {
            let (to, value) = match *instruction {
                MachineInstruction::Load(to, place) => (to, self.at(place)),
                MachineInstruction::Store(place, from) => {
                    self.memory.insert(place, self.register(from));
                    continue;
                }
                MachineInstruction::Copy(to, from) => (to, self.register(from)),
                MachineInstruction::Binary(operator, to, a, b) => {
                    let (a, b) = (self.register(a), self.operand(b));
                    let value = match operator {
                        Binary::Add => a + b,
                        Binary::Subtract => a - b,
                        Binary::Multiply => a * b,
                        Binary::Divide => a / b,
                        Binary::Maximum => {
                            if a > b {
                                a
                            } else {
                                b
                            }
                        }
                        Binary::Minimum => {
                            if a < b {
                                a
                            } else {
                                b
                            }
                        }
                        Binary::ExclusiveOr => f64::from_bits(a.to_bits() ^ b.to_bits()),
                    };
                    (to, value)
                }
                MachineInstruction::Fused(operator, order, to, b, c) => {
                    let (d, b, c) = (self.register(to), self.register(b), self.operand(c));
                    let (x, y, z) = match order {
                        FusedOrder::D132 => (d, c, b),
                        FusedOrder::D213 => (b, d, c),
                        FusedOrder::D231 => (b, c, d),
                    };
                    let value = match operator {
                        Fused::MultiplyAdd => x.mul_add(y, z),
                        Fused::MultiplySubtract => x.mul_add(y, -z),
                        Fused::SubtractProduct => subtract_product(z, x, y),
                    };
                    (to, value)
                }
                MachineInstruction::RoundToSingle(to, from) => (to, f64::from(self.register(from) as f32)),
            };
            self.registers[usize::from(to.0)] = Some(value);
        }
    }
}

fn allocated(
    program: &Program,
    (registers, plan): (u8, RoundPlan),
    fuses: bool,
    (states, constants): (&[f64], &[f64]),
    rounds: usize,
) -> Vec<f64> {
    let code = Allocation::of(&lowered(program, fuses, plan.ends), registers, plan);
    let mut machine = Machine { registers: vec![None; registers.into()], memory: HashMap::new() };
    for (i, state) in states.iter().enumerate() {
        machine.memory.insert(ValueLocation::State(i), *state);
    }
    for (k, constant) in constants.iter().enumerate() {
        machine.memory.insert(ValueLocation::Constant(k), *constant);
    }
    machine.run(&code.before);
    (0..rounds).for_each(|_| machine.run(&code.round));
    machine.run(&code.after);
    let place = |i| match plan.ends {
        ResultDestination::Elsewhere => ValueLocation::Result(i),
        ResultDestination::Carried | ResultDestination::InPlace => ValueLocation::State(i),
    };
    (0..program.outputs.len()).map(|i| machine.at(place(i))).collect()
}

#[test]
fn any_number_of_registers_computes_what_the_program_says() {
    let mut draw = Draw(17);
    for case in 0..1500 {
        let (states, constants) = (1 + draw.below(6), draw.below(8));
        let program = random_program(&mut draw, states, constants, 3 + case % 60);
        let numbers = |draw: &mut Draw, count| (0..count).map(|_| draw.number(300)).collect::<Vec<f64>>();
        let (x, c) = (numbers(&mut draw, states), numbers(&mut draw, constants));
        let registers = FEWEST_REGISTERS + draw.below(14) as u8;
        for ends in [ResultDestination::Elsewhere, ResultDestination::InPlace, ResultDestination::Carried] {
            if ends == ResultDestination::Carried && usize::from(registers - FEWEST_REGISTERS) < states {
                continue;
            }
            let rounds = if ends == ResultDestination::Elsewhere { 1 } else { 3 };
            for (fuses, keeps) in [(false, false), (false, true), (true, false), (true, true)] {
                let plan = RoundPlan { ends, keeps_constants: keeps };
                let found = allocated(&program, (registers, plan), fuses, (&x, &c), rounds);
                let expected = (0..rounds).fold(x.clone(), |x, _| run(&program, &x, &c, fuses));
                let agree = found.iter().zip(&expected).all(|(a, b)| same(*a, *b));
                assert!(
                    agree,
                    "case {case}, {registers} registers, {plan:?}, fused {fuses}: {found:?}, {expected:?}\n{program:?}"
                );
            }
        }
    }
}

#[test]
fn a_last_use_takes_no_instruction_of_its_own() {
    let mut program = Program::default();
    let [a, b, c] = [0, 1, 2].map(|i| push(&mut program, state(i)));
    let sum = push(&mut program, Instruction::MultiplyAdd(a, b, c));
    program.outputs = vec![sum];
    let plan = RoundPlan { ends: ResultDestination::Elsewhere, keeps_constants: false };
    let round = Allocation::of(&lowered(&program, true, plan.ends), 16, plan).round;
    let [
        MachineInstruction::Load(..),
        MachineInstruction::Load(..),
        MachineInstruction::Fused(.., Source::Memory(_)),
        MachineInstruction::Store(..),
    ] = round[..]
    else {
        panic!("{round:?}")
    };
}
