//! Registers, memory, and what moves between them.

use crate::assembler::Vector;
use crate::lines::{Ends, Given};

use super::allocator::Allocator;
use super::{Operand, Operation, Place};

impl Allocator<'_> {
    pub(super) fn source(&self, line: usize) -> Operand {
        match (self.register_of[line], self.home[line]) {
            (Some(register), _) => Operand::Register(register),
            (None, Some(place)) => Operand::Memory(place),
            (None, None) => unreachable!("a value is somewhere until its last use"),
        }
    }

    pub(super) fn source_register(&self, line: usize) -> Vector {
        self.register_of[line].unwrap_or_else(|| unreachable!("the operand was brought into a register"))
    }

    /// The register of an operand, into which it is loaded if need be.
    pub(super) fn in_register(&mut self, line: usize, time: usize) -> Vector {
        if let Operand::Memory(place) = self.source(line) {
            let register = self.fresh(time);
            self.code.operations.push(Operation::Load(register, place));
            self.registers[usize::from(register.0)] = Some(line);
            self.register_of[line] = Some(register);
        }
        self.lock(line);
        self.source_register(line)
    }

    /// An operand that may stand in memory.
    pub(super) fn operand(&mut self, line: usize, time: usize) -> Operand {
        if self.is_worth_loading(line, time) {
            return Operand::Register(self.in_register(line, time));
        }
        self.lock(line);
        self.source(line)
    }

    /// Whether a value in memory is read again, and there is room for it.
    pub(super) fn is_worth_loading(&self, line: usize, time: usize) -> bool {
        let is_variable =
            !matches!(self.home[line], Some(Place::Given(Given::Constant(_) | Given::Literal(_))) | None);
        self.register_of[line].is_none()
            && is_variable
            && self.uses.next_after(line, time).is_some()
            && self.registers.contains(&None)
    }

    pub(super) fn lock(&mut self, line: usize) {
        if let Some(register) = self.register_of[line].filter(|_| !self.is_kept[line]) {
            self.locked[usize::from(register.0)] = true;
        }
    }

    /// A register for the line at hand: the one that it is carried in, where that is free.
    pub(super) fn target(&mut self, time: usize) -> Vector {
        let carried = self.results_of[time].first().filter(|_| self.ends == Ends::Carried);
        match carried {
            Some(&i) if self.registers[i].is_none() => Vector(i as u8),
            _ => self.fresh(time),
        }
    }

    /// A register to write to: a free one, or that of the value that is used last.
    pub(super) fn fresh(&mut self, time: usize) -> Vector {
        let index = match self.registers.iter().position(Option::is_none) {
            Some(free) => free,
            None => self.give_up(time),
        };
        let taken = 1 + self.registers.iter().filter(|register| register.is_some()).count();
        self.code.most_taken = self.code.most_taken.max(taken as u8);
        Vector(index as u8)
    }

    /// Empties the register whose value is used farthest away.
    pub(super) fn give_up(&mut self, time: usize) -> usize {
        let next = |register: &usize| {
            self.registers[*register].and_then(|line| self.uses.next_after(line, time)).unwrap_or(usize::MAX)
        };
        let farthest = (0..self.registers.len()).filter(|register| !self.locked[*register]).max_by_key(next);
        let register =
            farthest.unwrap_or_else(|| unreachable!("an operation has fewer operands than registers"));
        if let Some(line) = self.registers[register].take() {
            if self.home[line].is_none() {
                let slot = self.free_slots.pop().unwrap_or_else(|| {
                    self.code.slots += 1;
                    self.code.slots - 1
                });
                self.home[line] = Some(Place::Slot(slot));
                self.code.operations.push(Operation::Store(Place::Slot(slot), Vector(register as u8)));
            }
            self.register_of[line] = None;
        }
        register
    }

    /// The line at hand has read these; what is not used again gives up its register.
    pub(super) fn release(&mut self, lines: &[usize], time: usize) {
        for &line in lines {
            self.uses.end(line, time);
            self.drop_dead(line);
        }
        self.locked.fill(false);
    }

    pub(super) fn drop_dead(&mut self, line: usize) {
        if self.uses.next(line).is_none()
            && !self.is_kept[line]
            && let Some(register) = self.register_of[line].take()
        {
            self.registers[usize::from(register.0)] = None;
        }
    }

    /// Slots are free again after the line that reads them last.
    pub(super) fn free_slots_of(&mut self, lines: &[usize]) {
        for &line in lines {
            if self.uses.next(line).is_none()
                && let Some(Place::Slot(slot)) = self.home[line]
            {
                self.home[line] = None;
                self.free_slots.push(slot);
            }
        }
    }

    /// The line at hand is in this register now.
    pub(super) fn define(&mut self, line: usize, register: Vector) {
        self.registers[usize::from(register.0)] = Some(line);
        self.register_of[line] = Some(register);
    }
}
