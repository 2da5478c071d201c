//! An assembler for the instructions of x86-64 that straight lines of floats need.
//!
//! In: one call an instruction, on registers and memory. Out: bytes. Instructions are those of AVX,
//! of FMA, and of AVX-512F and AVX-512VL where a register beyond the first sixteen or of 512 bits
//! takes part.
//! Numbers that stand in the code itself are in a pool behind it (Intel, Software Developer's
//! Manual, volume 2).

mod encoding;
mod general;
mod operands;
mod pool;
#[cfg(test)]
mod tests;

use encoding::Opcode;
use pool::Pool;

pub(crate) use general::Condition;
pub(crate) use operands::{Element, Form, General, Memory, Source, Vector, Width};
pub(crate) use pool::Entry;

/// An operation on two operands, by its opcode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Binary {
    Add = 0x58,
    Subtract = 0x5c,
    Multiply = 0x59,
    Divide = 0x5e,
    /// a where a > b, else b
    Maximum = 0x5f,
    /// a where a < b, else b
    Minimum = 0x5d,
    /// The bits of a, those flipped that are set in b. Of single numbers, the other bits of the
    /// register are flipped as well: a memory operand is 16 bytes at least.
    ExclusiveOr = 0x57,
}

/// A fused operation on a product: what it adds to the opcode of an [`Order`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Fused {
    /// product + addend
    MultiplyAdd = 0,
    /// product − addend
    MultiplySubtract = 2,
    /// addend − product
    SubtractProduct = 4,
}

/// Which of the operands d, b, c of a fused operation are multiplied; d is overwritten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    /// d·c and b
    D132 = 0x98,
    /// b·d and c
    D213 = 0xa8,
    /// b·c and d
    D231 = 0xb8,
}

/// Code that is being written, for operands of one form.
#[derive(Debug)]
pub(crate) struct Assembler {
    bytes: Vec<u8>,
    form: Form,
    pool: Pool,
}

impl Assembler {
    pub(crate) fn new(form: Form) -> Self {
        Assembler { bytes: Vec::new(), form, pool: Pool::new(form) }
    }

    /// What its operands are.
    pub(crate) fn form(&self) -> Form {
        self.form
    }

    /// An entry of the array of operands that begins at a base.
    pub(crate) fn entry(&self, base: General, index: usize) -> Memory {
        let offset = i32::try_from(index * self.form.bytes());
        Memory::At { base, offset: offset.expect("programs are short, and their arrays within reach") }
    }

    /// to = a ∘ b
    pub(crate) fn binary(&mut self, operator: Binary, to: Vector, a: Vector, b: Source) {
        let opcode = match operator {
            Binary::ExclusiveOr => Opcode::exclusive_or(self.form),
            _ => Opcode::of(self.form, operator as u8),
        };
        self.vector(opcode, to, a, b);
    }

    /// A product and a sum or a difference, rounded once, into `to`, which is an operand too.
    pub(crate) fn fused(&mut self, operator: Fused, order: Order, to: Vector, b: Vector, c: Source) {
        self.vector(Opcode::fused(self.form, order as u8 + operator as u8), to, b, c);
    }

    /// Copies a whole register.
    pub(crate) fn copy(&mut self, to: Vector, from: Vector) {
        self.vector(Opcode::packed(self.form, 0x28), to, Vector::NONE, Source::Register(from));
    }

    pub(crate) fn load(&mut self, to: Vector, from: Memory) {
        self.vector(Opcode::of(self.form, 0x10), to, Vector::NONE, Source::Memory(from));
    }

    pub(crate) fn store(&mut self, to: Memory, from: Vector) {
        self.vector(Opcode::of(self.form, 0x11), from, Vector::NONE, Source::Memory(to));
    }

    /// The number of single precision nearest to a number, as one of this form.
    pub(crate) fn round_to_single(&mut self, to: Vector, from: Vector) {
        if self.form.element == Element::Single {
            return self.copy(to, from);
        }
        // The rest of the register comes from a further operand, which vectors have no use for.
        let rest = |register| if self.form.width == Width::Scalar { register } else { Vector::NONE };
        let (rest, rest_of_single) = (rest(from), rest(to));
        let single = Form { element: Element::Single, ..self.form };
        self.vector(Opcode::convert(self.form), to, rest, Source::Register(from));
        self.vector(Opcode::convert(single), to, rest_of_single, Source::Register(to));
    }

    /// Leaves the upper halves of the registers as code that knows only their lower halves wants
    /// them.
    pub(crate) fn zero_upper(&mut self) {
        self.bytes.extend([0xc5, 0xf8, 0x77]);
    }

    /// A place in the pool that holds a number in every lane; `bits` are those of one.
    pub(crate) fn constant(&mut self, bits: u64) -> Entry {
        self.pool.entry(bits)
    }

    /// The code and its pool.
    pub(crate) fn finish(self) -> Vec<u8> {
        self.pool.append_to(self.bytes)
    }
}
