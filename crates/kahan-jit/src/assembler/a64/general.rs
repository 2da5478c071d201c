//! General-purpose registers, integer instructions, the stack and jumps.

use super::Assembler;

/// A general-purpose register. Number 31 is the stack pointer in an address, and the zero register
/// elsewhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct GeneralRegister(u8);

impl GeneralRegister {
    /// The argument registers of a function, in the order of the arguments.
    pub(crate) const ARGUMENTS: [Self; 5] = [Self(0), Self(1), Self(2), Self(3), Self(4)];
    /// Caller-saved registers that hold no arguments.
    pub(crate) const SPARE: [Self; 3] = [Self(9), Self(10), Self(11)];
    /// The registers in which a sweep holds the addresses of its columns.
    pub(crate) const POINTERS: [Self; 13] = [
        Self(5),
        Self(6),
        Self(7),
        Self(12),
        Self(13),
        Self(14),
        Self(15),
        Self(19),
        Self(20),
        Self(21),
        Self(22),
        Self(23),
        Self(24),
    ];
    /// The callee-saved registers among [`POINTERS`](Self::POINTERS), in adjacent pairs.
    pub(super) const SAVED: [Self; 6] = [Self(19), Self(20), Self(21), Self(22), Self(23), Self(24)];
    pub(crate) const STACK: Self = Self(31);
    /// Scratch register for offsets and addresses that do not fit into an instruction.
    pub(super) const BEYOND: Self = Self(16);

    pub(super) fn number(self) -> u32 {
        self.0.into()
    }
}

/// The kind of two adjacent registers that one instruction saves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pair {
    /// Two vector registers, of which the lower 64 bits are saved.
    Vectors,
    General,
}

/// The target of a backward jump, as an offset in bytes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Label(pub(crate) usize);

#[derive(Debug)]
#[must_use]
pub(crate) struct ForwardJump(usize);

/// The five constants are the opcodes of cbz, cbnz, b.lo, b.hs and b, in this order.
const IF_ZERO: u32 = 0xb400_0000;
const IF_NOT_ZERO: u32 = 0xb500_0000;
const IF_BELOW: u32 = 0x5400_0003;
const UNLESS_BELOW: u32 = 0x5400_0002;
const ALWAYS: u32 = 0x1400_0000;

impl Assembler {
    pub(crate) fn move_general(&mut self, to: GeneralRegister, from: GeneralRegister) {
        self.word(0xaa00_03e0 | from.number() << 16 | to.number());
    }

    pub(crate) fn clear(&mut self, to: GeneralRegister) {
        self.word(0xd280_0000 | to.number());
    }

    pub(crate) fn add_general(&mut self, to: GeneralRegister, from: GeneralRegister) {
        self.word(0x8b00_0000 | from.number() << 16 | to.number() << 5 | to.number());
    }

    /// Adds an unsigned 12-bit number, which the instruction contains.
    pub(crate) fn add_immediate(&mut self, to: GeneralRegister, number: i32) {
        let number = u32::try_from(number).ok().filter(|number| *number < 1 << 12);
        let number = number.expect("the bytes of a register") << 10;
        self.word(0x9100_0000 | number | to.number() << 5 | to.number());
    }

    pub(crate) fn load_general(&mut self, to: GeneralRegister, base: GeneralRegister, offset: i32) {
        self.access([0xf940_0000, 0xf860_6800], to.number(), base, offset, 8);
    }

    /// Loads or stores `size` bytes at base + offset. `words` holds two opcodes: the first takes
    /// the offset as a 12-bit multiple of `size`, the second takes it in a register.
    pub(super) fn access(
        &mut self,
        words: [u32; 2],
        register: u32,
        base: GeneralRegister,
        offset: i32,
        size: usize,
    ) {
        let [near, far] = words;
        let offset = u32::try_from(offset).expect("entries stand behind the beginning of their array");
        let size = size as u32;
        if offset.is_multiple_of(size) && offset / size < 1 << 12 {
            return self.word(near | (offset / size) << 10 | base.number() << 5 | register);
        }
        // movz and movk load the offset into a register.
        self.word(0xd280_0000 | (offset & 0xffff) << 5 | GeneralRegister::BEYOND.number());
        if offset >> 16 != 0 {
            self.word(0xf2a0_0000 | (offset >> 16) << 5 | GeneralRegister::BEYOND.number());
        }
        self.indexed(far, register, base, GeneralRegister::BEYOND);
    }

    pub(super) fn indexed(
        &mut self,
        word: u32,
        register: u32,
        base: GeneralRegister,
        index: GeneralRegister,
    ) {
        self.word(word | index.number() << 16 | base.number() << 5 | register);
    }

    /// Writes adrp, which loads the page address of a pool entry; the address is patched later.
    pub(super) fn page_of_pool(&mut self) {
        self.word(0x9000_0000 | GeneralRegister::BEYOND.number());
    }

    /// Saves the frame record (stp, mov) in a new stack frame of `bytes` bytes.
    pub(super) fn begin_frame(&mut self, bytes: u32) {
        let offset = (bytes / 8).wrapping_neg() & 0x7f;
        self.word(0xa980_7bfd | offset << 15);
        self.word(0x9100_03fd);
    }

    /// Writes ldp x29, x30, which restores the frame record.
    pub(super) fn end_frame(&mut self, bytes: u32) {
        self.word(0xa8c0_7bfd | (bytes / 8) << 15);
    }

    pub(super) fn store_pair(&mut self, pair: Pair, first: u32, offset: u32) {
        self.pair(pair, 0, first, offset);
    }

    pub(super) fn load_pair(&mut self, pair: Pair, first: u32, offset: u32) {
        self.pair(pair, 1 << 22, first, offset);
    }

    fn pair(&mut self, pair: Pair, load: u32, first: u32, offset: u32) {
        let word = if pair == Pair::Vectors { 0x6d00_03e0 } else { 0xa900_03e0 };
        self.word(word | load | (offset / 8) << 15 | (first + 1) << 10 | first);
    }

    /// Writes `sub sp, sp, #bytes`, where `bytes` is at most the size of a page.
    pub(super) fn lower_stack(&mut self, bytes: usize) {
        const PAGES: u32 = 1 << 22;

        let bytes = bytes as u32;
        let number = if bytes >= 1 << 12 { PAGES | (bytes >> 12) << 10 } else { bytes << 10 };
        self.word(0xd100_03ff | number);
    }

    /// Writes mov sp, x29, which resets the stack pointer to the frame record.
    pub(super) fn restore_stack(&mut self) {
        self.word(0x9100_03bf);
    }

    /// Writes str xzr, [sp], which touches the stack at its new end.
    pub(super) fn touch_stack(&mut self) {
        self.word(0xf900_03ff);
    }

    pub(super) fn ret(&mut self) {
        self.word(0xd65f_03c0);
    }

    /// Returns the current position in the code, to which later instructions can jump back.
    pub(crate) fn label(&self) -> Label {
        Label(self.bytes.len())
    }

    /// Jumps forward if `count` is zero. [`bind`](Self::bind) sets the target later.
    pub(crate) fn skip_if_zero(&mut self, count: GeneralRegister) -> ForwardJump {
        ForwardJump(self.jump(IF_ZERO | count.number(), IF_NOT_ZERO | count.number()))
    }

    /// Decrements `count`, and jumps to the label unless the result is zero.
    pub(crate) fn count_down(&mut self, count: GeneralRegister, Label(to): Label) {
        self.word(0xd100_0400 | count.number() << 5 | count.number());
        let place = self.jump(IF_NOT_ZERO | count.number(), IF_ZERO | count.number());
        set_target(&mut self.bytes, place, to);
    }

    /// Jumps to the label if a < b as unsigned numbers.
    pub(crate) fn repeat_below(&mut self, a: GeneralRegister, b: GeneralRegister, Label(to): Label) {
        self.word(0xeb00_001f | b.number() << 16 | a.number() << 5);
        let place = self.jump(IF_BELOW, UNLESS_BELOW);
        set_target(&mut self.bytes, place, to);
    }

    /// Writes a conditional jump, and returns its position. In long code, where the target may be
    /// out of reach, the opposite condition jumps over an unconditional branch.
    fn jump(&mut self, condition: u32, opposite: u32) -> usize {
        const OVER_THE_NEXT: u32 = 2 << 5;

        let word = if self.is_long {
            self.word(opposite | OVER_THE_NEXT);
            ALWAYS
        } else {
            condition
        };
        self.word(word);
        self.bytes.len() - 4
    }

    pub(crate) fn bind(&mut self, ForwardJump(place): ForwardJump) {
        let target = self.bytes.len();
        set_target(&mut self.bytes, place, target);
    }
}

fn change(code: &mut [u8], place: usize, change: impl FnOnce(u32) -> u32) {
    let word = code[place..].first_chunk_mut().expect("an instruction stands there");
    *word = change(u32::from_le_bytes(*word)).to_le_bytes();
}

/// Writes the distance from `place` to the target into the branch instruction at `place`. Panics if
/// the distance does not fit, which the limits on code length prevent.
pub(super) fn set_target(code: &mut [u8], place: usize, target: usize) {
    change(code, place, |word| {
        let (bits, shift) = if word & 0xfc00_0000 == ALWAYS { (26, 0) } else { (19, 5) };
        let words = (target as i64 - place as i64) / 4;
        assert!((-(1 << (bits - 1))..1 << (bits - 1)).contains(&words), "within reach");
        word | (words as u32 & ((1 << bits) - 1)) << shift
    });
}

/// Patches two instructions: adrp gets the distance to the page of `target`, and the load gets the
/// offset in this page.
pub(super) fn refer_by_page(code: &mut [u8], place: usize, target: usize, size: usize) {
    let pages = ((target >> 12) as i64 - (place >> 12) as i64) as u32;
    change(code, place, |word| word | (pages & 3) << 29 | (pages >> 2 & 0x7_ffff) << 5);
    let entry = (target & 0xfff) / size;
    change(code, place + 4, |word| word | (entry as u32) << 10);
}
