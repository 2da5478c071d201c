//! Tracks which values the registers hold, and moves values between registers and memory.

use crate::assembler::{Source, Vector};
use crate::lowering::ResultDestination;

use super::allocator::Allocator;
use super::{MachineInstruction, ValueLocation};

impl Allocator<'_> {
    pub(super) fn source(&self, value: usize) -> Source<ValueLocation> {
        match (self.register_of[value], self.home[value]) {
            (Some(register), _) => Source::Register(register),
            (None, Some(place)) => Source::Memory(place),
            (None, None) => unreachable!("a value is somewhere until its last use"),
        }
    }

    pub(super) fn source_register(&self, value: usize) -> Vector {
        self.register_of[value].unwrap_or_else(|| unreachable!("the operand was brought into a register"))
    }

    /// Returns the register of an operand. Loads the operand first if it is in memory.
    pub(super) fn in_register(&mut self, value: usize) -> Vector {
        if let Source::Memory(place) = self.source(value) {
            let register = self.fresh();
            self.code.round.push(MachineInstruction::Load(register, place));
            self.registers[usize::from(register.0)] = Some(value);
            self.register_of[value] = Some(register);
        }
        self.lock(value);
        self.source_register(value)
    }

    /// Returns an operand, which stays in memory if loading does not pay.
    pub(super) fn operand(&mut self, value: usize) -> Source<ValueLocation> {
        if self.is_worth_loading(value) {
            return Source::Register(self.in_register(value));
        }
        self.lock(value);
        self.source(value)
    }

    /// Returns whether to load a value from memory into a register: the value is no constant and is
    /// read again, and a register is free.
    pub(super) fn is_worth_loading(&self, value: usize) -> bool {
        let is_variable =
            !matches!(self.home[value], Some(ValueLocation::Constant(_) | ValueLocation::Literal(_)) | None);
        self.register_of[value].is_none()
            && is_variable
            && self.uses.next_after(value, self.time).is_some()
            && self.registers.contains(&None)
    }

    pub(super) fn lock(&mut self, value: usize) {
        if let Some(register) = self.register_of[value].filter(|_| !self.is_kept[value]) {
            self.locked[usize::from(register.0)] = true;
        }
    }

    /// Returns a register for the current value. A value that becomes state i of the next round
    /// gets register i if that is free.
    pub(super) fn target(&mut self) -> Vector {
        let carried = self.results_of[self.time].first().filter(|_| self.ends == ResultDestination::Carried);
        match carried {
            Some(&i) if self.registers[i].is_none() => Vector(i as u8),
            _ => self.fresh(),
        }
    }

    /// Returns a register to write to. If none is free, `spill` frees one.
    pub(super) fn fresh(&mut self) -> Vector {
        let index = match self.registers.iter().position(Option::is_none) {
            Some(free) => free,
            None => self.spill(),
        };
        let taken = 1 + self.registers.iter().filter(|register| register.is_some()).count();
        self.code.most_taken = self.code.most_taken.max(taken as u8);
        Vector(index as u8)
    }

    pub(super) fn spill(&mut self) -> usize {
        let next = |register: &usize| {
            self.registers[*register]
                .and_then(|value| self.uses.next_after(value, self.time))
                .unwrap_or(usize::MAX)
        };
        let farthest = (0..self.registers.len()).filter(|register| !self.locked[*register]).max_by_key(next);
        let register =
            farthest.unwrap_or_else(|| unreachable!("an instruction has fewer operands than registers"));
        if let Some(value) = self.registers[register].take() {
            if self.home[value].is_none() {
                let slot = self.free_slots.pop().unwrap_or_else(|| {
                    self.code.slots += 1;
                    self.code.slots - 1
                });
                self.home[value] = Some(ValueLocation::Slot(slot));
                self.code
                    .round
                    .push(MachineInstruction::Store(ValueLocation::Slot(slot), Vector(register as u8)));
            }
            self.register_of[value] = None;
        }
        register
    }

    /// Records these values as read, and frees the registers of values that are not read again.
    pub(super) fn release(&mut self, values: &[usize]) {
        for &value in values {
            self.uses.end(value, self.time);
            self.drop_dead(value);
        }
        self.locked.fill(false);
    }

    pub(super) fn drop_dead(&mut self, value: usize) {
        if self.uses.next(value).is_none()
            && !self.is_kept[value]
            && let Some(register) = self.register_of[value].take()
        {
            self.registers[usize::from(register.0)] = None;
        }
    }

    pub(super) fn free_slots_of(&mut self, values: &[usize]) {
        for &value in values {
            if self.uses.next(value).is_none()
                && let Some(ValueLocation::Slot(slot)) = self.home[value]
            {
                self.home[value] = None;
                self.free_slots.push(slot);
            }
        }
    }

    pub(super) fn define(&mut self, value: usize, register: Vector) {
        self.registers[usize::from(register.0)] = Some(value);
        self.register_of[value] = Some(register);
    }
}
