//! Register allocation in one pass: gives each operation a register and a machine instruction.
//! Inputs and constants are loaded only if needed.

use kahan_program::Node;

use crate::assembler::{Binary, Fused, FusedOrder, Vector};
use crate::lowering::ResultDestination;
use crate::program::{CalledFunction, Input, Instruction, Program};

use super::moves::move_results;
use super::uses::Uses;
use super::{Allocation, MachineInstruction, ValueLocation};

pub(super) struct Allocator<'a> {
    pub(super) program: &'a Program,
    pub(super) ends: ResultDestination,
    pub(super) time: usize,
    pub(super) uses: Uses,
    /// The value that each register holds. Registers reserved for constants are left out.
    pub(super) registers: Vec<Option<usize>>,
    pub(super) locked: Vec<bool>,
    pub(super) register_of: Vec<Option<Vector>>,
    pub(super) home: Vec<Option<ValueLocation>>,
    pub(super) is_kept: Vec<bool>,
    pub(super) free_slots: Vec<usize>,
    /// For each value, the indices of the results that are equal to this value.
    pub(super) results_of: Vec<Vec<usize>>,
    /// For each result, whether it is stored last, because an operation may read the old state.
    pub(super) waits: Vec<bool>,
    pub(super) code: Allocation,
}

impl<'a> Allocator<'a> {
    /// Prepares a pass. The constants in `kept` stay in the registers with the highest numbers.
    pub(super) fn new(program: &'a Program, registers: u8, ends: ResultDestination, kept: &[usize]) -> Self {
        let count = program.operations.len();
        let own = usize::from(registers) - kept.len();
        let mut allocator = Allocator {
            program,
            ends,
            time: 0,
            uses: Uses::of(program),
            registers: vec![None; own],
            locked: vec![false; own],
            register_of: vec![None; count],
            home: program
                .operations
                .iter()
                .map(|instruction| ValueLocation::initial_location(*instruction))
                .collect(),
            is_kept: vec![false; count],
            free_slots: Vec::new(),
            results_of: vec![Vec::new(); count],
            waits: Vec::new(),
            code: Allocation::default(),
        };
        for (k, &value) in kept.iter().enumerate() {
            let (register, source) = (Vector((own + k) as u8), allocator.source(value));
            allocator.code.before.push(MachineInstruction::load_into(register, source));
            allocator.register_of[value] = Some(register);
            allocator.is_kept[value] = true;
        }
        allocator.expect_results();
        allocator
    }

    /// Finds each result's destination, and whether the result must be stored last.
    fn expect_results(&mut self) {
        let results: Vec<usize> = self.program.outputs.iter().map(|output| output.0).collect();
        let mut states: Vec<Option<usize>> = vec![None; results.len()];
        for (value, instruction) in self.program.operations.iter().enumerate() {
            if let Instruction::Input(Input::State(i)) = *instruction
                && let Some(state) = states.get_mut(i)
            {
                *state = Some(value);
            }
        }
        for (i, (&result, state)) in results.iter().zip(states).enumerate() {
            let is_read_later = |state: usize| state != result && self.uses.last(state) > Some(result);
            let waits = match self.ends {
                ResultDestination::Carried => true,
                ResultDestination::InPlace => state.is_some_and(is_read_later),
                ResultDestination::Elsewhere => false,
            };
            self.waits.push(waits);
            self.results_of[result].push(i);
            if self.ends == ResultDestination::Carried {
                let (place, register) = (ValueLocation::State(i), Vector(i as u8));
                self.code.before.push(MachineInstruction::Load(register, place));
                self.code.after.push(MachineInstruction::Store(place, register));
                self.code.most_taken = results.len() as u8;
                if let Some(state) = state {
                    self.home[state] = None;
                    self.define(state, register);
                }
            }
        }
        let waiting = results.iter().zip(&self.waits).filter(|(_, waits)| **waits);
        waiting.for_each(|(result, _)| self.uses.add(*result, self.program.operations.len()));
    }

    pub(super) fn run(mut self) -> Allocation {
        for (time, instruction) in self.program.operations.iter().enumerate() {
            self.time = time;
            self.write(*instruction);
            self.locked.fill(false);
            self.store_results();
        }
        self.time = self.program.operations.len();
        match self.ends {
            ResultDestination::Carried => {
                let sources = self.program.outputs.iter().map(|output| self.source(output.0)).collect();
                move_results(sources, self.registers.len(), &mut self.code);
            }
            ResultDestination::InPlace => self.store_last(),
            ResultDestination::Elsewhere => {}
        }
        self.code
    }

    fn write(&mut self, instruction: Instruction) {
        match instruction {
            Instruction::Input(_) | Instruction::Constant(_) => {}
            Instruction::Add(a, b) => self.binary(Binary::Add, a, b),
            Instruction::Subtract(a, b) => self.binary(Binary::Subtract, a, b),
            Instruction::Multiply(a, b) => self.binary(Binary::Multiply, a, b),
            Instruction::Divide(a, b) => self.binary(Binary::Divide, a, b),
            Instruction::Call(CalledFunction::Maximum, a, b) => self.binary(Binary::Maximum, a, b),
            Instruction::Call(CalledFunction::Minimum, a, b) => self.binary(Binary::Minimum, a, b),
            Instruction::Negate(a) => self.binary(Binary::ExclusiveOr, a, Node(self.uses.sign())),
            Instruction::MultiplyAdd(a, b, c) => self.fused(Fused::MultiplyAdd, [a, b, c]),
            Instruction::MultiplySubtract(a, b, c) => self.fused(Fused::MultiplySubtract, [a, b, c]),
            Instruction::SubtractProduct(a, b, c) => self.fused(Fused::SubtractProduct, [b, c, a]),
            Instruction::Call(CalledFunction::Copy, Node(a), _) => {
                let source = self.source(a);
                self.finish(&[a], |to| MachineInstruction::load_into(to, source));
            }
            Instruction::Call(CalledFunction::RoundToSingle, Node(a), _) => {
                let from = self.in_register(a);
                self.finish(&[a], |to| MachineInstruction::RoundToSingle(to, from));
            }
        }
    }

    /// Stores the current value as a result, unless the result must be stored last.
    fn store_results(&mut self) {
        let value = self.time;
        let Some(register) = self.register_of[value].filter(|_| !self.is_kept[value]) else { return };
        for &i in &self.results_of[value] {
            if !self.waits[i] {
                let place = if self.ends == ResultDestination::InPlace {
                    ValueLocation::State(i)
                } else {
                    ValueLocation::Result(i)
                };
                self.code.round.push(MachineInstruction::Store(place, register));
            }
        }
        self.drop_dead(value);
    }

    fn store_last(&mut self) {
        for (i, output) in self.program.outputs.iter().enumerate() {
            if self.waits[i] {
                let register = self.in_register(output.0);
                self.locked.fill(false);
                self.code.round.push(MachineInstruction::Store(ValueLocation::State(i), register));
            }
        }
    }

    fn binary(&mut self, operator: Binary, Node(a): Node, Node(b): Node) {
        let commutes = matches!(operator, Binary::Add | Binary::Multiply);
        let is_swapped = commutes && self.register_of[a].is_none() && self.register_of[b].is_some();
        let (a, b) = if is_swapped { (b, a) } else { (a, b) };
        let first = self.in_register(a);
        let second = self.operand(b);
        self.finish(&[a, b], |to| MachineInstruction::Binary(operator, to, first, second));
    }

    /// Writes a fused multiply-add, which overwrites one of its operands.
    fn fused(&mut self, operator: Fused, operands: [Node; 3]) {
        let operands = operands.map(|operand| operand.0);
        let [mut a, mut b, c] = operands;
        for operand in operands {
            self.lock(operand);
        }
        // A fused multiply-add reads at most one operand from memory. The others are loaded.
        for operand in [c, b, a] {
            let in_memory = |value: &usize| self.register_of[*value].is_none();
            let is_only = operands.iter().filter(|value| in_memory(value)).count() == 1;
            if in_memory(&operand) && (!is_only || self.is_worth_loading(operand)) {
                self.in_register(operand);
            }
        }
        let dies = |value: usize| {
            self.register_of[value].is_some()
                && !self.is_kept[value]
                && self.uses.next_after(value, self.time).is_none()
        };
        if !dies(a) && dies(b) {
            (a, b) = (b, a);
        }
        let (to, overwritten) = if dies(c) {
            (self.source_register(c), c)
        } else if dies(a) {
            (self.source_register(a), a)
        } else {
            // The result gets a new register, which first receives an operand: one from memory if
            // there is one, otherwise a copy of the addend c.
            let overwritten =
                operands.into_iter().find(|value| self.register_of[*value].is_none()).unwrap_or(c);
            if overwritten == b {
                (a, b) = (b, a);
            }
            let source = self.source(overwritten);
            let to = self.fresh();
            self.code.round.push(MachineInstruction::load_into(to, source));
            (to, overwritten)
        };
        let (order, second, third) = if overwritten == c {
            // Only b may be in memory in `D231`, so a and b are exchanged if a is there.
            if self.register_of[a].is_none() {
                (a, b) = (b, a);
            }
            (FusedOrder::D231, self.source_register(a), self.source(b))
        } else if self.register_of[b].is_none() {
            (FusedOrder::D132, self.source_register(c), self.source(b))
        } else {
            (FusedOrder::D213, self.source_register(b), self.source(c))
        };
        self.code.round.push(MachineInstruction::Fused(operator, order, to, second, third));
        self.release(&operands);
        self.define(self.time, to);
        self.free_slots_of(&operands);
    }

    fn finish(&mut self, operands: &[usize], instruction: impl FnOnce(Vector) -> MachineInstruction) {
        self.release(operands);
        let to = self.target();
        self.code.round.push(instruction(to));
        self.define(self.time, to);
        self.free_slots_of(operands);
    }
}
