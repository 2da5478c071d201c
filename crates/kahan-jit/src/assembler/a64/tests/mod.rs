//! Compares instructions with the words that GNU binutils assembles from their text.

mod memory;
mod operations;

use super::general::{self, ForwardJump};
use super::{
    Assembler, Binary, Element, FrameNeeds, Fused, FusedOrder, GeneralRegister, Memory, OperandForm, Source,
    Vector, Width,
};

const fn form(element: Element, width: Width) -> OperandForm {
    OperandForm { element, width }
}

const S: OperandForm = form(Element::Single, Width::Scalar);
const D: OperandForm = form(Element::Double, Width::Scalar);
const S4: OperandForm = form(Element::Single, Width::Bits128);
const D2: OperandForm = form(Element::Double, Width::Bits128);

/// The text of instructions, their operand form, a call that writes them, and the expected words.
type Written<'a> = (&'a str, OperandForm, &'a dyn Fn(&mut Assembler), &'a [u32]);

type Frame<'a> = ((usize, bool, u8), &'a [u32]);

/// Returns a register by its index in [`Vector`]: 8 to 21 stand for v16 to v29, and 22 to 29 for
/// v8 to v15.
fn v(register: u8) -> Vector {
    Vector(register)
}

fn r(register: u8) -> Source {
    Source::Register(v(register))
}

fn g(register: u8) -> GeneralRegister {
    let all =
        GeneralRegister::ARGUMENTS.into_iter().chain(GeneralRegister::SPARE).chain(GeneralRegister::POINTERS);
    all.into_iter().find(|known| known.number() == u32::from(register)).expect("it has a name")
}

fn at(base: GeneralRegister, offset: i32) -> Memory {
    Memory::At { base, offset }
}

fn words(bytes: &[u8]) -> Vec<u32> {
    assert!(bytes.len().is_multiple_of(4), "instructions are words");
    bytes.as_chunks().0.iter().map(|word| u32::from_le_bytes(*word)).collect()
}

fn check(all: &[Written<'_>]) {
    for (text, form, write, expected) in all {
        let mut assembler = Assembler::new(*form);
        write(&mut assembler);
        let found = words(&assembler.bytes);
        assert_eq!(found, *expected, "{text}: {found:08x?}, not {expected:08x?}");
    }
}

fn frame((stack, uses_pointers, vectors): (usize, bool, u8)) -> Vec<u32> {
    let needs = FrameNeeds { stack, uses_pointers, vectors, instructions: 1 };
    let mut assembler = Assembler::new(D);
    assembler.open(&needs);
    assembler.close(&needs);
    assert!(!assembler.is_long && assembler.form() == D);
    words(&assembler.bytes)
}

#[rustfmt::skip]
#[test]
fn a_function_leaves_the_registers_of_its_caller_as_they_were() {
    let frames: &[Frame<'_>] = &[
        ((0, false, 22), &[
            0xd65f_03c0, // ret
        ]),
        ((0, false, 23), &[
            0xa9be_7bfd, // stp x29, x30, [sp, #-32]!
            0x9100_03fd, // mov x29, sp
            0x6d01_27e8, // stp d8, d9, [sp, #16]
            0x6d41_27e8, // ldp d8, d9, [sp, #16]
            0xa8c2_7bfd, // ldp x29, x30, [sp], #32
            0xd65f_03c0, // ret
        ]),
        ((0, true, 30), &[
            0xa9b8_7bfd, // stp x29, x30, [sp, #-128]!
            0x9100_03fd, // mov x29, sp
            0x6d01_27e8, // stp d8, d9, [sp, #16]
            0x6d02_2fea, // stp d10, d11, [sp, #32]
            0x6d03_37ec, // stp d12, d13, [sp, #48]
            0x6d04_3fee, // stp d14, d15, [sp, #64]
            0xa905_53f3, // stp x19, x20, [sp, #80]
            0xa906_5bf5, // stp x21, x22, [sp, #96]
            0xa907_63f7, // stp x23, x24, [sp, #112]
            0x6d41_27e8, // ldp d8, d9, [sp, #16]
            0x6d42_2fea, // ldp d10, d11, [sp, #32]
            0x6d43_37ec, // ldp d12, d13, [sp, #48]
            0x6d44_3fee, // ldp d14, d15, [sp, #64]
            0xa945_53f3, // ldp x19, x20, [sp, #80]
            0xa946_5bf5, // ldp x21, x22, [sp, #96]
            0xa947_63f7, // ldp x23, x24, [sp, #112]
            0xa8c8_7bfd, // ldp x29, x30, [sp], #128
            0xd65f_03c0, // ret
        ]),
        ((8, false, 3), &[
            0xa9bf_7bfd, // stp x29, x30, [sp, #-16]!
            0x9100_03fd, // mov x29, sp
            0xd100_43ff, // sub sp, sp, #16
            0xf900_03ff, // str xzr, [sp]
            0x9100_03bf, // mov sp, x29
            0xa8c1_7bfd, // ldp x29, x30, [sp], #16
            0xd65f_03c0, // ret
        ]),
        ((9000, true, 25), &[
            0xa9ba_7bfd, // stp x29, x30, [sp, #-96]!
            0x9100_03fd, // mov x29, sp
            0x6d01_27e8, // stp d8, d9, [sp, #16]
            0x6d02_2fea, // stp d10, d11, [sp, #32]
            0xa903_53f3, // stp x19, x20, [sp, #48]
            0xa904_5bf5, // stp x21, x22, [sp, #64]
            0xa905_63f7, // stp x23, x24, [sp, #80]
            0xd140_07ff, // sub sp, sp, #4096
            0xf900_03ff, // str xzr, [sp]
            0xd140_07ff, // sub sp, sp, #4096
            0xf900_03ff, // str xzr, [sp]
            0xd10c_c3ff, // sub sp, sp, #816
            0xf900_03ff, // str xzr, [sp]
            0x9100_03bf, // mov sp, x29
            0x6d41_27e8, // ldp d8, d9, [sp, #16]
            0x6d42_2fea, // ldp d10, d11, [sp, #32]
            0xa943_53f3, // ldp x19, x20, [sp, #48]
            0xa944_5bf5, // ldp x21, x22, [sp, #64]
            0xa945_63f7, // ldp x23, x24, [sp, #80]
            0xa8c6_7bfd, // ldp x29, x30, [sp], #96
            0xd65f_03c0, // ret
        ]),
        ((4096, false, 24), &[
            0xa9be_7bfd, // stp x29, x30, [sp, #-32]!
            0x9100_03fd, // mov x29, sp
            0x6d01_27e8, // stp d8, d9, [sp, #16]
            0xd140_07ff, // sub sp, sp, #4096
            0xf900_03ff, // str xzr, [sp]
            0x9100_03bf, // mov sp, x29
            0x6d41_27e8, // ldp d8, d9, [sp, #16]
            0xa8c2_7bfd, // ldp x29, x30, [sp], #32
            0xd65f_03c0, // ret
        ]),
    ];
    for (needs, expected) in frames {
        assert_eq!(frame(*needs), *expected, "{needs:?}");
    }
}

fn jumps(is_long: bool) -> Vec<u32> {
    let [a, b, ..] = GeneralRegister::ARGUMENTS;
    let mut assembler = Assembler::new(D);
    assembler.is_long = is_long;
    let again = assembler.label();
    let end: ForwardJump = assembler.skip_if_zero(a);
    assembler.count_down(b, again);
    assembler.repeat_below(a, b, again);
    assembler.bind(end);
    words(&assembler.bytes)
}

#[test]
fn jumps_lead_where_they_are_bound() {
    // cbz x0, .+20; sub x1, x1, #1; cbnz x1, .-8; cmp x0, x1; b.lo .-16
    assert_eq!(jumps(false), [0xb400_00a0, 0xd100_0421, 0xb5ff_ffc1, 0xeb01_001f, 0x54ff_ff83]);
    // cbnz x0, .+8; b .+28; sub x1, x1, #1; cbz x1, .+8; b .-16; cmp x0, x1; b.hs .+8; b .-28
    let long = [
        0xb500_0040,
        0x1400_0007,
        0xd100_0421,
        0xb400_0041,
        0x17ff_fffc,
        0xeb01_001f,
        0x5400_0042,
        0x17ff_fff9,
    ];
    assert_eq!(jumps(true), long);
}

#[test]
#[should_panic(expected = "within reach")]
fn a_jump_beyond_its_reach_is_never_written() {
    let mut code = 0xb400_0000_u32.to_le_bytes().to_vec();
    general::set_target(&mut code, 0, 1 << 20);
}

#[test]
fn numbers_of_the_pool_stand_behind_the_code_in_every_lane() {
    // ldr s0, .+64; ldr d0, .+64; ldr q0, .+64; ldr q0, .+64
    for (form, word) in [(S, 0x1c00_0200), (D, 0x5c00_0200), (S4, 0x9c00_0200), (D2, 0x9c00_0200)] {
        let mut assembler = Assembler::new(form);
        let entry = assembler.constant(0x8000_0000_3f80_0000);
        assembler.load(v(0), Memory::Pool(entry));
        let bytes = assembler.finish();
        assert_eq!(words(&bytes[..8]), [word, 0], "{form:?}");
        let element = if form.element == Element::Double { 8 } else { 4 };
        let lanes = bytes[64..].chunks(element);
        assert_eq!(bytes.len(), 80);
        assert!(lanes.into_iter().all(|lane| *lane == 0x8000_0000_3f80_0000_u64.to_le_bytes()[..element]));
    }
}

#[test]
fn long_code_finds_its_numbers_by_their_page() {
    // adrp x16, .+8192; then ldr d0, ldr s0 or ldr q0 from [x16, #16]
    for (form, near) in [(D, 0xfd40_0a00), (S, 0xbd40_1200), (D2, 0x3dc0_0600)] {
        let mut assembler = Assembler::new(form);
        let instructions = 50_000;
        assembler.open(&FrameNeeds { stack: 0, uses_pointers: false, vectors: 0, instructions });
        let entries = [1, 2].map(|bits| assembler.constant(bits));
        assembler.load(v(0), Memory::Pool(entries[1]));
        while assembler.bytes.len() < 0x2000 {
            assembler.ret();
        }
        let bytes = assembler.finish();
        assert_eq!(words(&bytes[..8]), [0xd000_0010, near], "{form:?}");
        assert_eq!(bytes[0x2010], 2);
    }
}

/// Some operating systems keep a thread's data in x18, so code must not use this register.
#[test]
fn no_register_of_a_system_is_named() {
    let all =
        GeneralRegister::ARGUMENTS.into_iter().chain(GeneralRegister::SPARE).chain(GeneralRegister::POINTERS);
    let mut numbers: Vec<u32> = all.map(GeneralRegister::number).collect();
    numbers.sort_unstable();
    numbers.dedup();
    assert_eq!(numbers.len(), 5 + 3 + 13, "each has one use");
    assert!(numbers.iter().all(|number| ![16, 17, 18, 25, 26, 27, 28, 29, 30, 31].contains(number)));
}
