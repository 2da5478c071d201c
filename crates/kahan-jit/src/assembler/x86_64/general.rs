//! General-purpose registers, integer instructions and jumps.

use super::{Assembler, Memory, Source};

/// A general-purpose register, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum GeneralRegister {
    Rax,
    Rcx,
    Rdx,
    Rbx,
    Rsp,
    Rbp,
    Rsi,
    Rdi,
    R8,
    R9,
    R10,
    R11,
    R12,
    R13,
    R14,
    R15,
}

impl GeneralRegister {
    /// The argument registers of a function, in the order of the arguments.
    pub(crate) const ARGUMENTS: [Self; 5] = [Self::Rdi, Self::Rsi, Self::Rdx, Self::Rcx, Self::R8];
    /// Caller-saved registers that hold no arguments.
    pub(crate) const SPARE: [Self; 3] = [Self::Rax, Self::R9, Self::R10];
    /// The registers in which a sweep holds the addresses of its columns.
    pub(crate) const POINTERS: [Self; 6] = [Self::R11, Self::Rbx, Self::R12, Self::R13, Self::R14, Self::R15];
    /// The callee-saved registers among [`POINTERS`](Self::POINTERS).
    pub(super) const SAVED: [Self; 5] = [Self::Rbx, Self::R12, Self::R13, Self::R14, Self::R15];
    pub(crate) const STACK: Self = Self::Rsp;
}

/// The condition that a jump tests on the flags. The values are x86 condition codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Condition {
    /// Tests a < b for unsigned numbers.
    Below = 2,
    Zero = 4,
    NotZero = 5,
}

/// The target of a backward jump, as an offset in bytes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Label(pub(crate) usize);

#[derive(Debug)]
#[must_use]
pub(crate) struct ForwardJump(usize);

impl Assembler {
    /// Writes an instruction on `other`. `register` is a second register, or three opcode bits.
    fn on_registers(&mut self, opcode: u8, register: u8, other: GeneralRegister) {
        let other = other as u8;
        let prefix = 0x48 | register >> 3 << 2 | other >> 3;
        self.bytes.extend([prefix, opcode, 0xc0 | (register & 7) << 3 | other & 7]);
    }

    pub(crate) fn move_general(&mut self, to: GeneralRegister, from: GeneralRegister) {
        self.on_registers(0x89, from as u8, to);
    }

    pub(crate) fn add_general(&mut self, to: GeneralRegister, from: GeneralRegister) {
        self.on_registers(0x01, from as u8, to);
    }

    pub(crate) fn add_immediate(&mut self, to: GeneralRegister, number: i32) {
        self.on_registers(0x81, 0, to);
        self.bytes.extend(number.to_le_bytes());
    }

    pub(super) fn and_immediate(&mut self, to: GeneralRegister, number: i32) {
        self.on_registers(0x81, 4, to);
        self.bytes.extend(number.to_le_bytes());
    }

    pub(crate) fn clear(&mut self, to: GeneralRegister) {
        self.and_immediate(to, 0);
    }

    pub(super) fn compare(&mut self, a: GeneralRegister, b: GeneralRegister) {
        self.on_registers(0x39, b as u8, a);
    }

    pub(super) fn test(&mut self, a: GeneralRegister) {
        self.on_registers(0x85, a as u8, a);
    }

    pub(super) fn decrement(&mut self, a: GeneralRegister) {
        self.on_registers(0xff, 1, a);
    }

    pub(crate) fn load_general(&mut self, to: GeneralRegister, base: GeneralRegister, offset: i32) {
        let register = to as u8;
        self.bytes.extend([0x48 | register >> 3 << 2 | base as u8 >> 3, 0x8b]);
        self.operands(register, Source::Memory(Memory::At { base, offset }), true);
    }

    pub(super) fn push(&mut self, a: GeneralRegister) {
        self.short(0x50, a);
    }

    pub(super) fn pop(&mut self, a: GeneralRegister) {
        self.short(0x58, a);
    }

    fn short(&mut self, opcode: u8, a: GeneralRegister) {
        let number = a as u8;
        if number >= 8 {
            self.bytes.push(0x41);
        }
        self.bytes.push(opcode | number & 7);
    }

    /// Touches the end of the stack without changing the number that lies there.
    pub(super) fn touch_stack(&mut self) {
        // or qword ptr [rsp], 0
        self.bytes.extend([0x48, 0x83, 0x0c, 0x24, 0]);
    }

    pub(super) fn ret(&mut self) {
        self.bytes.push(0xc3);
    }

    /// Returns the current position in the code, to which later instructions can jump back.
    pub(crate) fn label(&self) -> Label {
        Label(self.bytes.len())
    }

    /// Jumps forward if `count` is zero. [`bind`](Self::bind) sets the target later.
    pub(crate) fn skip_if_zero(&mut self, count: GeneralRegister) -> ForwardJump {
        self.test(count);
        self.jump_if_forward(Condition::Zero)
    }

    /// Decrements `count`, and jumps to the label unless the result is zero.
    pub(crate) fn count_down(&mut self, count: GeneralRegister, to: Label) {
        self.decrement(count);
        self.jump_if(Condition::NotZero, to);
    }

    /// Jumps to the label if a < b as unsigned numbers.
    pub(crate) fn repeat_below(&mut self, a: GeneralRegister, b: GeneralRegister, to: Label) {
        self.compare(a, b);
        self.jump_if(Condition::Below, to);
    }

    pub(super) fn jump_if(&mut self, condition: Condition, to: Label) {
        let ForwardJump(after) = self.jump_if_forward(condition);
        self.set_target(after, to.0);
    }

    /// Jumps forward if the condition holds. [`bind`](Self::bind) sets the target later.
    pub(super) fn jump_if_forward(&mut self, condition: Condition) -> ForwardJump {
        self.bytes.extend([0x0f, 0x80 | condition as u8, 0, 0, 0, 0]);
        ForwardJump(self.bytes.len())
    }

    pub(crate) fn bind(&mut self, ForwardJump(after): ForwardJump) {
        self.set_target(after, self.bytes.len());
    }

    /// Sets the target of the jump instruction that ends at `after`.
    fn set_target(&mut self, after: usize, target: usize) {
        let distance = target as i32 - after as i32;
        self.bytes[after - 4..after].copy_from_slice(&distance.to_le_bytes());
    }
}
