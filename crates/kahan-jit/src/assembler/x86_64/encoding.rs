//! The encoding of vector instructions: each has a prefix, an opcode and operands.
//!
//! VEX prefixes allow 16 registers of up to 256 bits, and EVEX prefixes 32 registers of up to 512
//! bits. Prefixes hold the high bits of register numbers, inverted.

use super::{Assembler, Element, GeneralRegister, Memory, OperandForm, Source, Vector, Width};

/// The prefix fields and opcode of an instruction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Opcode {
    /// Opcode map: 1 for opcodes after the byte 0F, 2 for opcodes after the bytes 0F 38.
    map: u8,
    /// Mandatory prefix: 0 for none, 1 for the byte 66, 2 for F3, 3 for F2.
    prefix: u8,
    /// The W bit, which is set for double precision.
    is_wide: bool,
    /// Vector length: 0 for 128 bits, 1 for 256 bits, 2 for 512 bits.
    length: u8,
    opcode: u8,
    /// The mandatory prefix and the opcode in EVEX, if these differ from those in VEX.
    other: Option<(u8, u8)>,
}

impl Opcode {
    /// Describes an instruction that has scalar and vector forms.
    pub(super) fn of(form: OperandForm, opcode: u8) -> Self {
        let prefix = match (form.width, form.element) {
            (Width::Scalar, Element::Single) => 2,
            (Width::Scalar, Element::Double) => 3,
            (_, element) => u8::from(element == Element::Double),
        };
        Opcode { prefix, ..Self::packed(form, opcode) }
    }

    /// Describes an instruction that has only vector forms; scalars use the 128-bit form.
    pub(super) fn packed(form: OperandForm, opcode: u8) -> Self {
        let is_wide = form.element == Element::Double;
        let length = match form.width {
            Width::Scalar | Width::Bits128 => 0,
            Width::Bits256 => 1,
            Width::Bits512 => 2,
        };
        Opcode { map: 1, prefix: u8::from(is_wide), is_wide, length, opcode, other: None }
    }

    /// Describes a fused multiply-add. The scalar opcode is one larger than the vector opcode.
    pub(super) fn fused(form: OperandForm, opcode: u8) -> Self {
        let opcode = opcode + u8::from(form.width == Width::Scalar);
        Opcode { map: 2, prefix: 1, ..Self::packed(form, opcode) }
    }

    /// Describes xor, of which AVX-512F has only the integer form.
    pub(super) fn exclusive_or(form: OperandForm) -> Self {
        Opcode { other: Some((1, 0xef)), ..Self::packed(form, 0x57) }
    }

    /// Describes a conversion from the element type of `from` to the other element type.
    pub(super) fn convert(from: OperandForm) -> Self {
        Self::of(from, 0x5a)
    }
}

fn inverted(number: u8, k: u8) -> u8 {
    !(number >> k) & 1
}

impl Assembler {
    pub(super) fn vector(&mut self, opcode: Opcode, to: Vector, a: Vector, b: Source) {
        // ModRM and SIB hold the lowest three bits of register numbers, and the prefix holds the
        // higher bits. `x` and `base` are the higher bits for the registers in b.
        let (x, base) = match b {
            Source::Register(Vector(number)) => (number >> 4, number >> 3 & 1),
            Source::Memory(Memory::At { base, .. }) => (0, base as u8 >> 3),
            Source::Memory(Memory::Indexed { base, index }) => (index as u8 >> 3, base as u8 >> 3),
            Source::Memory(Memory::Pool(_)) => (0, 0),
        };
        let is_beyond = |register: Vector| register.0 >= 16;
        let is_evex = opcode.length == 2
            || is_beyond(to)
            || is_beyond(a)
            || matches!(b, Source::Register(register) if is_beyond(register));
        let Opcode { map, length, is_wide, .. } = opcode;
        let (prefix, code) = match opcode.other {
            Some(other) if is_evex => other,
            _ => (opcode.prefix, opcode.opcode),
        };
        // In VEX, only fused multiply-adds (map 2) use the bit W for the element type.
        let wide = u8::from(is_wide && (is_evex || map == 2)) << 7;
        let second = (!a.0 & 15) << 3;
        if is_evex {
            let high = inverted(to.0, 3) << 7 | (x ^ 1) << 6 | (base ^ 1) << 5 | inverted(to.0, 4) << 4;
            let last = length << 5 | inverted(a.0, 4) << 3;
            self.bytes.extend([0x62, high | map, wide | second | 4 | prefix, last]);
        } else if map == 1 && x == 0 && base == 0 {
            self.bytes.extend([0xc5, inverted(to.0, 3) << 7 | second | length << 2 | prefix]);
        } else {
            let high = inverted(to.0, 3) << 7 | (x ^ 1) << 6 | (base ^ 1) << 5;
            self.bytes.extend([0xc4, high | map, wide | second | length << 2 | prefix]);
        }
        self.bytes.push(code);
        self.operands(to.0, b, !is_evex);
    }

    /// Writes ModRM, SIB and the offset. In EVEX the offset always takes 4 bytes, since EVEX scales
    /// short offsets.
    pub(super) fn operands(&mut self, register: u8, b: Source, may_be_short: bool) {
        /// In the base field of ModRM, 4 (`MORE`) announces a SIB byte. In mode 0, 5 means an
        /// address relative to the program counter.
        const MORE: u8 = 4;
        const BEHIND_THE_CODE: u8 = 5;

        let register = (register & 7) << 3;
        match b {
            Source::Register(Vector(number)) => self.bytes.push(0xc0 | register | number & 7),
            Source::Memory(Memory::At { base, offset }) => {
                let short = i8::try_from(offset).ok().filter(|_| may_be_short);
                let mode = if short.is_some() { 0x40 } else { 0x80 };
                let base = base as u8 & 7;
                self.bytes.push(mode | register | base);
                if base == MORE {
                    self.bytes.push(MORE << 3 | base);
                }
                match short {
                    Some(short) => self.bytes.push(short as u8),
                    None => self.bytes.extend(offset.to_le_bytes()),
                }
            }
            Source::Memory(Memory::Indexed { base, index }) => {
                assert!(index != GeneralRegister::Rsp, "this register is no index");
                let index = (index as u8 & 7) << 3;
                // The offset 0 is written, because the base registers rbp and r13 need an offset.
                if may_be_short {
                    self.bytes.extend([0x40 | register | MORE, index | base as u8 & 7, 0]);
                } else {
                    self.bytes.extend([0x80 | register | MORE, index | base as u8 & 7, 0, 0, 0, 0]);
                }
            }
            Source::Memory(Memory::Pool(entry)) => {
                self.bytes.push(register | BEHIND_THE_CODE);
                self.pool.note_use(self.bytes.len(), entry);
                self.bytes.extend([0; 4]);
            }
        }
    }
}
