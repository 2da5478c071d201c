//! An assembler for 64-bit Arm.
//!
//! The assembler writes A64 instructions on scalar floats and 128-bit Advanced SIMD registers (Arm
//! Architecture Reference Manual for A-profile, C6 and C7). Functions follow the C calling
//! convention (Procedure Call Standard for the Arm 64-bit Architecture) and preserve the lower
//! halves of v8 to v15. Functions never use x18, which some operating systems reserve.

mod general;
#[cfg(test)]
mod tests;

use super::operands::{self, Element, OperandForm, Vector, Width};
use super::pool::{Entry, Pool};
use super::{Binary, FrameNeeds, Fused, FusedOrder, PAGE};

pub(crate) use general::GeneralRegister;

pub(crate) type Memory = operands::Memory<GeneralRegister>;
type Source = operands::Source<Memory>;

const TEMPORARY: Vector = Vector(30);
/// The register that holds an operand loaded from memory.
const OPERAND: Vector = Vector(31);
/// The first of the eight callee-saved vector registers, in the numbering of [`Vector`].
const FIRST_SAVED: u8 = 22;

/// The number of bytes that a 19-bit offset of a branch or load can reach.
const REACH: usize = 1 << 20;

#[derive(Debug)]
pub(crate) struct Assembler {
    bytes: Vec<u8>,
    form: OperandForm,
    pool: Pool,
    /// Whether a jump target or the pool may be too far for a single instruction.
    is_long: bool,
}

/// Returns a register's machine number. Indices in [`Vector`] list caller-saved registers first.
fn number(Vector(index): Vector) -> u32 {
    match index {
        0..8 => index.into(),
        8..FIRST_SAVED => u32::from(index) + 8,
        FIRST_SAVED..30 => u32::from(index) - 14,
        _ => index.into(),
    }
}

impl Assembler {
    pub(crate) fn new(form: OperandForm) -> Self {
        Assembler { bytes: Vec::new(), form, pool: Pool::new(form), is_long: false }
    }

    pub(crate) fn form(&self) -> OperandForm {
        self.form
    }

    /// Begins a function, which saves registers and reserves stack slots.
    pub(crate) fn open(&mut self, needs: &FrameNeeds) {
        /// An operation takes at most twelve words of code, and 16 bytes for a constant.
        const LONGEST: usize = 12 * 4 + 16;

        self.is_long = needs.instructions >= REACH / LONGEST - PAGE / 4;
        let saved = SavedRegisters::of(needs);
        if saved.bytes() > 0 {
            self.begin_frame(saved.bytes());
            saved.each(|pair, first, offset| self.store_pair(pair, first, offset));
        }
        for touched in (0..needs.stack.next_multiple_of(16)).step_by(PAGE) {
            self.lower_stack(PAGE.min(needs.stack.next_multiple_of(16) - touched));
            self.touch_stack();
        }
    }

    /// Ends a function. `needs` must equal the needs that were passed to `open`.
    pub(crate) fn close(&mut self, needs: &FrameNeeds) {
        let saved = SavedRegisters::of(needs);
        if saved.bytes() > 0 {
            if needs.stack > 0 {
                self.restore_stack();
            }
            saved.each(|pair, first, offset| self.load_pair(pair, first, offset));
            self.end_frame(saved.bytes());
        }
        self.ret();
    }

    fn word(&mut self, word: u32) {
        self.bytes.extend(word.to_le_bytes());
    }

    fn precision(&self) -> u32 {
        u32::from(self.form.element == Element::Double) << 22
    }

    fn is_scalar(&self) -> bool {
        self.form.width == Width::Scalar
    }

    /// Writes an instruction with three register operands: the word `scalar` or `packed`.
    fn three(&mut self, [scalar, packed]: [u32; 2], to: Vector, a: Vector, b: Vector) {
        let word = if self.is_scalar() { scalar } else { packed };
        self.word(word | self.precision() | number(b) << 16 | number(a) << 5 | number(to));
    }

    fn bits(&mut self, word: u32, to: Vector, a: Vector, b: Vector) {
        self.word(word | number(b) << 16 | number(a) << 5 | number(to));
    }

    fn in_register(&mut self, operand: Source) -> Vector {
        match operand {
            Source::Register(register) => register,
            Source::Memory(place) => {
                self.load(OPERAND, place);
                OPERAND
            }
        }
    }

    /// Writes the instruction `to` = a ∘ b, where ∘ is `operator`.
    pub(crate) fn binary(&mut self, operator: Binary, to: Vector, a: Vector, b: Source) {
        let words = match operator {
            Binary::Add => [0x1e20_2800, 0x4e20_d400],
            Binary::Subtract => [0x1e20_3800, 0x4ea0_d400],
            Binary::Multiply => [0x1e20_0800, 0x6e20_dc00],
            Binary::Divide => [0x1e20_1800, 0x6e20_fc00],
            Binary::Maximum | Binary::Minimum => {
                let b = self.in_register(b);
                return self.choose(operator == Binary::Maximum, to, a, b);
            }
            // The instruction fneg flips the sign without a constant.
            Binary::ExclusiveOr => return self.negate(to, a),
        };
        let b = self.in_register(b);
        self.three(words, to, a, b);
    }

    /// Writes `to` = if a > b { a } else { b }. If `greater` is false, the condition is a < b.
    fn choose(&mut self, greater: bool, to: Vector, a: Vector, b: Vector) {
        const GREATER: u32 = 12;
        const LESS: u32 = 4;

        if self.is_scalar() {
            // For scalars, the words encode fcmp a, b and then fcsel to, a, b, condition.
            let condition = if greater { GREATER } else { LESS };
            self.word(0x1e20_2000 | self.precision() | number(b) << 16 | number(a) << 5);
            let select = 0x1e20_0c00 | self.precision() | condition << 12;
            return self.word(select | number(b) << 16 | number(a) << 5 | number(to));
        }
        // The instruction fcmgt sets the mask in the lanes where larger > smaller.
        let mask = if to == a || to == b { TEMPORARY } else { to };
        let (larger, smaller) = if greater { (a, b) } else { (b, a) };
        self.three([0, 0x6ea0_e400], mask, larger, smaller);
        if mask == to {
            // bsl takes a where the mask is set, else b.
            self.bits(0x6e60_1c00, to, a, b);
        } else if to == b {
            // bit takes a where the mask is set.
            self.bits(0x6ea0_1c00, to, a, mask);
        } else {
            // The instruction bif replaces `to` by b in the lanes where the mask is not set.
            self.bits(0x6ee0_1c00, to, b, mask);
        }
    }

    fn negate(&mut self, to: Vector, a: Vector) {
        let word = if self.is_scalar() { 0x1e21_4000 } else { 0x6ea0_f800 };
        self.word(word | self.precision() | number(a) << 5 | number(to));
    }

    /// Writes a fused multiply-add of `to`, b and c. Its result replaces `to`.
    pub(crate) fn fused(&mut self, operator: Fused, order: FusedOrder, to: Vector, b: Vector, c: Source) {
        let c = self.in_register(c);
        let (x, y, addend) = match order {
            FusedOrder::D132 => (to, c, b),
            FusedOrder::D213 => (b, to, c),
            FusedOrder::D231 => (b, c, to),
        };
        if self.is_scalar() {
            // The words encode fmadd, fnmsub and fmsub.
            let word = match operator {
                Fused::MultiplyAdd => 0x1f00_0000,
                Fused::MultiplySubtract => 0x1f20_8000,
                Fused::SubtractProduct => 0x1f00_8000,
            };
            let operands = number(y) << 16 | number(addend) << 10 | number(x) << 5 | number(to);
            return self.word(word | self.precision() | operands);
        }
        // The vector instructions fmla and fmls add to their destination, here `sum`.
        let sum = if addend == to && x != to && y != to { to } else { TEMPORARY };
        if operator == Fused::MultiplySubtract {
            self.negate(sum, addend);
        } else if sum != addend {
            self.copy(sum, addend);
        }
        // The words encode fmls and fmla.
        let word = if operator == Fused::SubtractProduct { 0x4ea0_cc00 } else { 0x4e20_cc00 };
        self.three([0, word], sum, x, y);
        if sum != to {
            self.copy(to, sum);
        }
    }

    /// Copies a whole vector register, or only its lowest lane in scalar code.
    pub(crate) fn copy(&mut self, to: Vector, from: Vector) {
        if self.is_scalar() {
            self.word(0x1e20_4000 | self.precision() | number(from) << 5 | number(to));
        } else {
            self.bits(0x4ea0_1c00, to, from, from);
        }
    }

    pub(crate) fn load(&mut self, to: Vector, from: Memory) {
        self.transfer(true, to, from);
    }

    pub(crate) fn store(&mut self, to: Memory, from: Vector) {
        self.transfer(false, from, to);
    }

    fn transfer(&mut self, is_load: bool, register: Vector, place: Memory) {
        // The words encode an access at an immediate offset, at an offset in a register, and
        // relative to the program counter.
        let words = match (self.form.width, self.form.element) {
            (Width::Scalar, Element::Single) => [0xbd00_0000, 0xbc20_6800, 0x1c00_0000],
            (Width::Scalar, Element::Double) => [0xfd00_0000, 0xfc20_6800, 0x5c00_0000],
            _ => [0x3d80_0000, 0x3ca0_6800, 0x9c00_0000],
        };
        let load = u32::from(is_load) << 22;
        let [near, far, behind] = words;
        match place {
            Memory::At { base, offset } => {
                let size = self.form.bytes();
                self.access([near | load, far | load], number(register), base, offset, size);
            }
            Memory::Indexed { base, index } => self.indexed(far | load, number(register), base, index),
            Memory::Pool(entry) if self.is_long => {
                self.pool.note_use(self.bytes.len(), entry);
                self.page_of_pool();
                self.word(near | load | GeneralRegister::BEYOND.number() << 5 | number(register));
            }
            Memory::Pool(entry) => {
                self.pool.note_use(self.bytes.len(), entry);
                self.word(behind | number(register));
            }
        }
    }

    /// Rounds numbers to single precision, and stores the results in the operands' float type.
    pub(crate) fn round_to_single(&mut self, to: Vector, from: Vector) {
        if self.form.element == Element::Single {
            return self.copy(to, from);
        }
        // The instructions are fcvt to single and fcvt back, or for vectors fcvtn and fcvtl.
        let [narrow, wide] =
            if self.is_scalar() { [0x1e62_4000, 0x1e22_c000] } else { [0x0e61_6800, 0x0e61_7800] };
        self.word(narrow | number(from) << 5 | number(to));
        self.word(wide | number(to) << 5 | number(to));
    }

    /// Returns the pool entry that holds a number in every lane. `bits` encodes the number.
    pub(crate) fn constant(&mut self, bits: u64) -> Entry {
        self.pool.entry(bits)
    }

    pub(crate) fn finish(self) -> Vec<u8> {
        /// Gaps are filled with zeros, which encode a permanently undefined instruction (udf).
        const UNDEFINED: u8 = 0;

        let (is_long, size) = (self.is_long, self.form.bytes());
        self.pool.append_to(self.bytes, UNDEFINED, |code, place, target| {
            if is_long {
                general::refer_by_page(code, place, target, size);
            } else {
                general::set_target(code, place, target);
            }
        })
    }
}

/// The registers that a function saves in pairs, at addresses above the frame record.
#[derive(Clone, Copy)]
struct SavedRegisters {
    vectors: u32,
    uses_pointers: bool,
    has_frame: bool,
}

impl SavedRegisters {
    fn of(needs: &FrameNeeds) -> Self {
        let vectors = u32::from(needs.vectors.saturating_sub(FIRST_SAVED).div_ceil(2));
        let uses_pointers = needs.uses_pointers;
        SavedRegisters { vectors, uses_pointers, has_frame: needs.stack > 0 || vectors > 0 || uses_pointers }
    }

    /// Returns the size in bytes of saved registers and frame record; 0 if nothing is saved.
    fn bytes(self) -> u32 {
        let pointers = if self.uses_pointers { GeneralRegister::SAVED.len() as u32 } else { 0 };
        if self.has_frame { 16 * (1 + self.vectors) + 8 * pointers } else { 0 }
    }

    /// Calls `pair` for each saved pair, with its kind, its first register and its stack offset.
    fn each(self, mut pair: impl FnMut(general::Pair, u32, u32)) {
        let vectors = (0..self.vectors).map(|k| (general::Pair::Vectors, 8 + 2 * k));
        let pointers = GeneralRegister::SAVED.into_iter().step_by(2).filter(|_| self.uses_pointers);
        let pointers = pointers.map(|register| (general::Pair::General, register.number()));
        for (k, (kind, first)) in (1..).zip(vectors.chain(pointers)) {
            pair(kind, first, 16 * k);
        }
    }
}
