//! One pass over the lines: each gets its operands, a register, and its operation.

use crate::assembler::{Binary, Fused, Order, Vector};
use crate::lines::{Ends, Given, Line, Lines};

use super::carried::carry;
use super::uses::Uses;
use super::{Operand, Operation, Place};

/// What a pass leaves.
pub(super) struct Code {
    pub(super) operations: Vec<Operation>,
    pub(super) slots: usize,
    /// The most registers that were taken at once, those of what is kept besides.
    pub(super) most_taken: u8,
}

/// The state of a pass.
pub(super) struct Allocator<'a> {
    pub(super) lines: &'a Lines,
    pub(super) ends: Ends,
    pub(super) uses: Uses,
    /// What is in each register; those of what is kept are not among them.
    pub(super) registers: Vec<Option<usize>>,
    /// Registers that hold an operand of the line at hand.
    pub(super) locked: Vec<bool>,
    pub(super) register_of: Vec<Option<Vector>>,
    /// Where a value stands in memory.
    pub(super) home: Vec<Option<Place>>,
    pub(super) is_kept: Vec<bool>,
    pub(super) free_slots: Vec<usize>,
    /// The results that each line is.
    pub(super) results_of: Vec<Vec<usize>>,
    /// Whether a result has to wait for the end of the round.
    pub(super) waits: Vec<bool>,
    pub(super) code: Code,
}

impl<'a> Allocator<'a> {
    /// Before the first line; the lines in `kept` have the last registers for themselves.
    pub(super) fn new(lines: &'a Lines, registers: u8, ends: Ends, kept: &[usize]) -> Self {
        let count = lines.lines.len();
        let own = usize::from(registers) - kept.len();
        let mut allocator = Allocator {
            lines,
            ends,
            uses: Uses::of(lines),
            registers: vec![None; own],
            locked: vec![false; own],
            register_of: vec![None; count],
            home: vec![None; count],
            is_kept: vec![false; count],
            free_slots: Vec::new(),
            results_of: vec![Vec::new(); count],
            waits: Vec::new(),
            code: Code { operations: Vec::new(), slots: 0, most_taken: 0 },
        };
        let mut states: Vec<Option<usize>> = vec![None; lines.results.len()];
        for (index, line) in lines.lines.iter().enumerate() {
            match *line {
                Line::Given(Given::State(i)) if ends == Ends::Carried => {
                    allocator.registers[i] = Some(index);
                    allocator.register_of[index] = Some(Vector(i as u8));
                }
                Line::Given(given) => {
                    allocator.home[index] = Some(Place::Given(given));
                    if let Given::State(i) = given
                        && let Some(state) = states.get_mut(i)
                    {
                        *state = Some(index);
                    }
                }
                _ => {}
            }
        }
        for (line, register) in allocator.kept_registers(kept) {
            allocator.register_of[line] = Some(register);
            allocator.is_kept[line] = true;
        }
        for ((i, &result), state) in lines.results.iter().enumerate().zip(states) {
            let is_read_later = |state: usize| state != result && allocator.uses.last(state) > Some(result);
            let waits = match ends {
                Ends::Carried => true,
                Ends::InPlace => state.is_some_and(is_read_later),
                Ends::Elsewhere => false,
            };
            allocator.waits.push(waits);
            allocator.results_of[result].push(i);
        }
        for (result, _) in lines.results.iter().zip(&allocator.waits).filter(|(_, waits)| **waits) {
            allocator.uses.add(*result, count);
        }
        if ends == Ends::Carried {
            allocator.code.most_taken = lines.results.len() as u8;
        }
        allocator
    }

    /// The register of each line that is kept.
    pub(super) fn kept_registers(&self, kept: &[usize]) -> Vec<(usize, Vector)> {
        let own = self.registers.len();
        kept.iter().enumerate().map(|(k, line)| (*line, Vector((own + k) as u8))).collect()
    }

    pub(super) fn run(mut self) -> Code {
        let lines = self.lines;
        for (time, line) in lines.lines.iter().enumerate() {
            match *line {
                Line::Given(_) => {}
                Line::Binary(operator, a, b) => self.binary(time, operator, a, b),
                Line::Fused(operator, operands) => self.fused(time, operator, operands),
                Line::Copy(a) => {
                    let source = self.source(a);
                    self.finish(time, &[a], |to| Operation::bring(to, source));
                }
                Line::RoundToSingle(a) => {
                    let from = self.in_register(a, time);
                    self.finish(time, &[a], |to| Operation::RoundToSingle(to, from));
                }
            }
            self.locked.fill(false);
            self.store_results(time);
        }
        match self.ends {
            Ends::Carried => {
                let sources: Vec<Operand> = lines.results.iter().map(|result| self.source(*result)).collect();
                let slots = &mut self.code.slots;
                carry(&sources, self.registers.len(), slots, &mut self.code.operations);
            }
            Ends::InPlace => self.store_last(),
            Ends::Elsewhere => {}
        }
        self.code
    }

    /// Results that need not wait, of the line at hand.
    fn store_results(&mut self, time: usize) {
        let Some(register) = self.register_of[time].filter(|_| !self.is_kept[time]) else { return };
        for &i in &self.results_of[time] {
            if !self.waits[i] {
                let place = match self.ends {
                    Ends::InPlace => Place::Given(Given::State(i)),
                    _ => Place::Result(i),
                };
                self.code.operations.push(Operation::Store(place, register));
            }
        }
        self.drop_dead(time);
    }

    /// Results that had to wait for the end.
    fn store_last(&mut self) {
        let (lines, end) = (self.lines, self.lines.lines.len());
        for (i, &result) in lines.results.iter().enumerate() {
            if self.waits[i] {
                let register = self.in_register(result, end);
                self.locked.fill(false);
                self.code.operations.push(Operation::Store(Place::Given(Given::State(i)), register));
            }
        }
    }

    fn binary(&mut self, time: usize, operator: Binary, a: usize, b: usize) {
        let commutes = matches!(operator, Binary::Add | Binary::Multiply);
        let is_swapped = commutes && self.register_of[a].is_none() && self.register_of[b].is_some();
        let (a, b) = if is_swapped { (b, a) } else { (a, b) };
        let first = self.in_register(a, time);
        let second = self.operand(b, time);
        self.finish(time, &[a, b], |to| Operation::Binary(operator, to, first, second));
    }

    /// One of the three operands is overwritten: the order of the instruction says which.
    fn fused(&mut self, time: usize, operator: Fused, [mut a, mut b, c]: [usize; 3]) {
        let operands = [a, b, c];
        for operand in operands {
            self.lock(operand);
        }
        // At most one operand may be in memory, and only once.
        for operand in [c, b, a] {
            let in_memory = |line: &usize| self.register_of[*line].is_none();
            let is_only = operands.iter().filter(|line| in_memory(line)).count() == 1;
            if in_memory(&operand) && (!is_only || self.is_worth_loading(operand, time)) {
                self.in_register(operand, time);
            }
        }
        let dies = |line: usize| {
            self.register_of[line].is_some()
                && !self.is_kept[line]
                && self.uses.next_after(line, time).is_none()
        };
        if !dies(a) && dies(b) {
            (a, b) = (b, a);
        }
        let (to, overwritten) = if dies(c) {
            (self.source_register(c), c)
        } else if dies(a) {
            (self.source_register(a), a)
        } else {
            // Into a register of its own goes what is in memory, or else the number that is added.
            let overwritten =
                operands.into_iter().find(|line| self.register_of[*line].is_none()).unwrap_or(c);
            if overwritten == b {
                (a, b) = (b, a);
            }
            let source = self.source(overwritten);
            let to = self.fresh(time);
            self.code.operations.push(Operation::bring(to, source));
            (to, overwritten)
        };
        let (order, second, third) = if overwritten == c {
            // The memory operand comes last.
            if self.register_of[a].is_none() {
                (a, b) = (b, a);
            }
            (Order::D231, self.source_register(a), self.source(b))
        } else if self.register_of[b].is_none() {
            (Order::D132, self.source_register(c), self.source(b))
        } else {
            (Order::D213, self.source_register(b), self.source(c))
        };
        self.code.operations.push(Operation::Fused(operator, order, to, second, third));
        self.release(&operands, time);
        self.define(time, to);
        self.free_slots_of(&operands);
    }

    /// An operation whose operands stand ready, and whose result goes to the register it is given.
    fn finish(&mut self, time: usize, operands: &[usize], operation: impl FnOnce(Vector) -> Operation) {
        self.release(operands, time);
        let to = self.target(time);
        self.code.operations.push(operation(to));
        self.define(time, to);
        self.free_slots_of(operands);
    }
}
