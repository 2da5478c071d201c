//! Instructions on addresses and counts, and jumps.

use super::Assembler;
use super::operands::{General, Memory, Source};

/// When a jump is taken, after a comparison or what sets the same flags.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Condition {
    /// The first was below the second, both without a sign.
    Below = 2,
    Zero = 4,
    NotZero = 5,
}

/// A place in the code to jump back to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Label(usize);

/// A jump whose target is not known yet.
#[derive(Debug)]
#[must_use]
pub(crate) struct Forward(usize);

impl Assembler {
    /// An instruction on two registers of 64 bits, or on one and a part of the opcode.
    fn on_registers(&mut self, opcode: u8, register: u8, other: General) {
        let other = other as u8;
        let prefix = 0x48 | register >> 3 << 2 | other >> 3;
        self.bytes.extend([prefix, opcode, 0xc0 | (register & 7) << 3 | other & 7]);
    }

    pub(crate) fn move_general(&mut self, to: General, from: General) {
        self.on_registers(0x89, from as u8, to);
    }

    pub(crate) fn add_general(&mut self, to: General, from: General) {
        self.on_registers(0x01, from as u8, to);
    }

    pub(crate) fn add_immediate(&mut self, to: General, number: i32) {
        self.on_registers(0x81, 0, to);
        self.bytes.extend(number.to_le_bytes());
    }

    pub(crate) fn and_immediate(&mut self, to: General, number: i32) {
        self.on_registers(0x81, 4, to);
        self.bytes.extend(number.to_le_bytes());
    }

    pub(crate) fn compare(&mut self, a: General, b: General) {
        self.on_registers(0x39, b as u8, a);
    }

    /// Compares with zero.
    pub(crate) fn test(&mut self, a: General) {
        self.on_registers(0x85, a as u8, a);
    }

    pub(crate) fn decrement(&mut self, a: General) {
        self.on_registers(0xff, 1, a);
    }

    /// Loads 64 bits from base + offset.
    pub(crate) fn load_general(&mut self, to: General, base: General, offset: i32) {
        let register = to as u8;
        self.bytes.extend([0x48 | register >> 3 << 2 | base as u8 >> 3, 0x8b]);
        self.operands(register, Source::Memory(Memory::At { base, offset }), true);
    }

    pub(crate) fn push(&mut self, a: General) {
        self.short(0x50, a);
    }

    pub(crate) fn pop(&mut self, a: General) {
        self.short(0x58, a);
    }

    fn short(&mut self, opcode: u8, a: General) {
        let number = a as u8;
        if number >= 8 {
            self.bytes.push(0x41);
        }
        self.bytes.push(opcode | number & 7);
    }

    /// Writes to the end of the stack without changing what is there.
    pub(crate) fn touch_stack(&mut self) {
        // or qword ptr [rsp], 0
        self.bytes.extend([0x48, 0x83, 0x0c, 0x24, 0]);
    }

    pub(crate) fn ret(&mut self) {
        self.bytes.push(0xc3);
    }

    /// This place.
    pub(crate) fn label(&self) -> Label {
        Label(self.bytes.len())
    }

    pub(crate) fn jump_if(&mut self, condition: Condition, to: Label) {
        let Forward(after) = self.jump_if_forward(condition);
        self.set_target(after, to.0);
    }

    /// A jump to a place that is still to be [bound](Self::bind).
    pub(crate) fn jump_if_forward(&mut self, condition: Condition) -> Forward {
        self.bytes.extend([0x0f, 0x80 | condition as u8, 0, 0, 0, 0]);
        Forward(self.bytes.len())
    }

    /// Lets a jump lead to this place.
    pub(crate) fn bind(&mut self, Forward(after): Forward) {
        self.set_target(after, self.bytes.len());
    }

    /// Distances are counted from after the jump.
    fn set_target(&mut self, after: usize, target: usize) {
        let distance = target as i32 - after as i32;
        self.bytes[after - 4..after].copy_from_slice(&distance.to_le_bytes());
    }
}
