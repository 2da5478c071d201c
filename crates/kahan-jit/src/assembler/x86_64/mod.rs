//! An assembler for x86-64.
//!
//! The assembler writes AVX and FMA instructions. Registers from the seventeenth on, and registers
//! of 512 bits, need AVX-512F (Intel, Software Developer's Manual, volume 2). Less than 512 bits of
//! the former need AVX-512VL, too. Functions follow the calling convention of System V.

mod encoding;
mod general;
#[cfg(test)]
mod tests;

use super::operands::{self, Element, OperandForm, Vector, Width};
use super::pool::{Entry, Pool};
use super::{Binary, FrameNeeds, Fused, FusedOrder, PAGE};
use encoding::Opcode;

pub(crate) use general::GeneralRegister;

pub(crate) type Memory = operands::Memory<GeneralRegister>;
type Source = operands::Source<Memory>;

impl Vector {
    /// Encodes an operand that the instruction does not use.
    const NONE: Self = Vector(0);
}

#[derive(Debug)]
pub(crate) struct Assembler {
    bytes: Vec<u8>,
    form: OperandForm,
    pool: Pool,
}

impl Assembler {
    pub(crate) fn new(form: OperandForm) -> Self {
        Assembler { bytes: Vec::new(), form, pool: Pool::new(form) }
    }

    pub(crate) fn form(&self) -> OperandForm {
        self.form
    }

    /// Begins a function, which saves registers and reserves stack slots.
    pub(crate) fn open(&mut self, needs: &FrameNeeds) {
        /// The stack slots start at a multiple of this number of bytes, the size of a cache line.
        const LINE: i32 = 64;
        const LENGTH: usize = 8;

        assert!(needs.vectors <= 32, "there are so many registers");
        self.bytes.reserve(needs.instructions * LENGTH);
        self.push(GeneralRegister::Rbp);
        self.move_general(GeneralRegister::Rbp, GeneralRegister::Rsp);
        if needs.uses_pointers {
            GeneralRegister::SAVED.into_iter().for_each(|register| self.push(register));
        }
        if needs.stack > 0 {
            self.and_immediate(GeneralRegister::Rsp, -LINE);
            for touched in (0..needs.stack).step_by(PAGE) {
                self.add_immediate(GeneralRegister::Rsp, -(PAGE.min(needs.stack - touched) as i32));
                self.touch_stack();
            }
            self.and_immediate(GeneralRegister::Rsp, -LINE);
        }
    }

    /// Ends a function. `needs` must equal the needs that were passed to `open`.
    pub(crate) fn close(&mut self, needs: &FrameNeeds) {
        if needs.uses_pointers {
            for (index, register) in (1..).zip(GeneralRegister::SAVED) {
                self.load_general(register, GeneralRegister::Rbp, -8 * index);
            }
        }
        self.move_general(GeneralRegister::Rsp, GeneralRegister::Rbp);
        self.pop(GeneralRegister::Rbp);
        self.zero_upper();
        self.ret();
    }

    /// Writes `to` = a ∘ b, where ∘ is `operator`. Scalar `ExclusiveOr` also changes upper lanes.
    pub(crate) fn binary(&mut self, operator: Binary, to: Vector, a: Vector, b: Source) {
        let opcode = match operator {
            Binary::Add => 0x58,
            Binary::Subtract => 0x5c,
            Binary::Multiply => 0x59,
            Binary::Divide => 0x5e,
            Binary::Maximum => 0x5f,
            Binary::Minimum => 0x5d,
            Binary::ExclusiveOr => return self.vector(Opcode::exclusive_or(self.form), to, a, b),
        };
        self.vector(Opcode::of(self.form, opcode), to, a, b);
    }

    /// Writes a fused multiply-add of `to`, b and c. Its result replaces `to`.
    pub(crate) fn fused(&mut self, operator: Fused, order: FusedOrder, to: Vector, b: Vector, c: Source) {
        let order = match order {
            FusedOrder::D132 => 0x98,
            FusedOrder::D213 => 0xa8,
            FusedOrder::D231 => 0xb8,
        };
        let operator = match operator {
            Fused::MultiplyAdd => 0,
            Fused::MultiplySubtract => 2,
            Fused::SubtractProduct => 4,
        };
        self.vector(Opcode::fused(self.form, order + operator), to, b, c);
    }

    pub(crate) fn copy(&mut self, to: Vector, from: Vector) {
        self.vector(Opcode::packed(self.form, 0x28), to, Vector::NONE, Source::Register(from));
    }

    pub(crate) fn load(&mut self, to: Vector, from: Memory) {
        self.vector(Opcode::of(self.form, 0x10), to, Vector::NONE, Source::Memory(from));
    }

    pub(crate) fn store(&mut self, to: Memory, from: Vector) {
        self.vector(Opcode::of(self.form, 0x11), from, Vector::NONE, Source::Memory(to));
    }

    /// Rounds numbers to single precision, and stores the results in the operands' float type.
    pub(crate) fn round_to_single(&mut self, to: Vector, from: Vector) {
        if self.form.element == Element::Single {
            return self.copy(to, from);
        }
        // Scalar conversions take the upper bits of the result from one more operand, here `rest`.
        let rest = |register| if self.form.width == Width::Scalar { register } else { Vector::NONE };
        let (rest, rest_of_single) = (rest(from), rest(to));
        let single = OperandForm { element: Element::Single, ..self.form };
        self.vector(Opcode::convert(self.form), to, rest, Source::Register(from));
        self.vector(Opcode::convert(single), to, rest_of_single, Source::Register(to));
    }

    /// Writes vzeroupper, which avoids a penalty in callers that use SSE instructions.
    fn zero_upper(&mut self) {
        self.bytes.extend([0xc5, 0xf8, 0x77]);
    }

    /// Returns the pool entry that holds a number in every lane. `bits` encodes the number.
    pub(crate) fn constant(&mut self, bits: u64) -> Entry {
        self.pool.entry(bits)
    }

    pub(crate) fn finish(self) -> Vec<u8> {
        const BREAKPOINT: u8 = 0xcc;

        self.pool.append_to(self.bytes, BREAKPOINT, |code, place, target| {
            // The processor adds the 4-byte offset to the address of the byte after the offset.
            let distance = target as i32 - (place as i32 + 4);
            code[place..place + 4].copy_from_slice(&distance.to_le_bytes());
        })
    }
}
