//! Encodings of loads, stores and integer instructions.

use super::{Binary, D, D2, GeneralRegister, Memory, S, S4, Source, at, check, g, v};

#[rustfmt::skip]
#[test]
fn numbers_are_loaded_and_stored_wherever_they_lie() {
    check(&[
        // ldr s0, [x0, #0]
        (S, &|x| x.load(v(0), at(g(0), 0x0)), &[0xbd40_0000]),
        // ldr s15, [x4, #16380]
        (S, &|x| x.load(v(29), at(g(4), 0x3ffc)), &[0xbd7f_fc8f]),
        // ldr s16, [sp, #4]
        (S, &|x| x.load(v(8), at(GeneralRegister::STACK, 0x4)), &[0xbd40_07f0]),
        // movz x16, #16384; ldr s3, [x15, x16]
        (S, &|x| x.load(v(3), at(g(15), 0x4000)), &[0xd288_0010, 0xbc70_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; ldr s31, [sp, x16]
        (S, &|x| x.load(v(31), at(GeneralRegister::STACK, 0x12345670)), &[0xd28a_ce10, 0xf2a2_4690, 0xbc70_6bff]),
        // ldr s20, [x24, x10]
        (S, &|x| x.load(v(12), Memory::Indexed { base: g(24), index: g(10) }), &[0xbc6a_6b14]),
        // str s0, [x0, #0]
        (S, &|x| x.store(at(g(0), 0x0), v(0)), &[0xbd00_0000]),
        // str s15, [x4, #16380]
        (S, &|x| x.store(at(g(4), 0x3ffc), v(29)), &[0xbd3f_fc8f]),
        // str s16, [sp, #4]
        (S, &|x| x.store(at(GeneralRegister::STACK, 0x4), v(8)), &[0xbd00_07f0]),
        // movz x16, #16384; str s3, [x15, x16]
        (S, &|x| x.store(at(g(15), 0x4000), v(3)), &[0xd288_0010, 0xbc30_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; str s31, [sp, x16]
        (S, &|x| x.store(at(GeneralRegister::STACK, 0x12345670), v(31)), &[0xd28a_ce10, 0xf2a2_4690, 0xbc30_6bff]),
        // str s20, [x24, x10]
        (S, &|x| x.store(Memory::Indexed { base: g(24), index: g(10) }, v(12)), &[0xbc2a_6b14]),
        // ldr s31, [x0, #4]; fadd s2, s1, s31
        (S, &|x| x.binary(Binary::Add, v(2), v(1), Source::Memory(at(g(0), 4))),
            &[0xbd40_041f, 0x1e3f_2822]),
        // ldr d0, [x0, #0]
        (D, &|x| x.load(v(0), at(g(0), 0x0)), &[0xfd40_0000]),
        // ldr d15, [x4, #32760]
        (D, &|x| x.load(v(29), at(g(4), 0x7ff8)), &[0xfd7f_fc8f]),
        // ldr d16, [sp, #8]
        (D, &|x| x.load(v(8), at(GeneralRegister::STACK, 0x8)), &[0xfd40_07f0]),
        // movz x16, #32768; ldr d3, [x15, x16]
        (D, &|x| x.load(v(3), at(g(15), 0x8000)), &[0xd290_0010, 0xfc70_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; ldr d31, [sp, x16]
        (D, &|x| x.load(v(31), at(GeneralRegister::STACK, 0x12345670)), &[0xd28a_ce10, 0xf2a2_4690, 0xfc70_6bff]),
        // ldr d20, [x24, x10]
        (D, &|x| x.load(v(12), Memory::Indexed { base: g(24), index: g(10) }), &[0xfc6a_6b14]),
        // str d0, [x0, #0]
        (D, &|x| x.store(at(g(0), 0x0), v(0)), &[0xfd00_0000]),
        // str d15, [x4, #32760]
        (D, &|x| x.store(at(g(4), 0x7ff8), v(29)), &[0xfd3f_fc8f]),
        // str d16, [sp, #8]
        (D, &|x| x.store(at(GeneralRegister::STACK, 0x8), v(8)), &[0xfd00_07f0]),
        // movz x16, #32768; str d3, [x15, x16]
        (D, &|x| x.store(at(g(15), 0x8000), v(3)), &[0xd290_0010, 0xfc30_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; str d31, [sp, x16]
        (D, &|x| x.store(at(GeneralRegister::STACK, 0x12345670), v(31)), &[0xd28a_ce10, 0xf2a2_4690, 0xfc30_6bff]),
        // str d20, [x24, x10]
        (D, &|x| x.store(Memory::Indexed { base: g(24), index: g(10) }, v(12)), &[0xfc2a_6b14]),
        // ldr d31, [x0, #8]; fadd d2, d1, d31
        (D, &|x| x.binary(Binary::Add, v(2), v(1), Source::Memory(at(g(0), 8))),
            &[0xfd40_041f, 0x1e7f_2822]),
        // ldr q0, [x0, #0]
        (S4, &|x| x.load(v(0), at(g(0), 0x0)), &[0x3dc0_0000]),
        // ldr q15, [x4, #65520]
        (S4, &|x| x.load(v(29), at(g(4), 0xfff0)), &[0x3dff_fc8f]),
        // ldr q16, [sp, #16]
        (S4, &|x| x.load(v(8), at(GeneralRegister::STACK, 0x10)), &[0x3dc0_07f0]),
        // movz x16, #0; movk x16, #1, lsl #16; ldr q3, [x15, x16]
        (S4, &|x| x.load(v(3), at(g(15), 0x10000)), &[0xd280_0010, 0xf2a0_0030, 0x3cf0_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; ldr q31, [sp, x16]
        (S4, &|x| x.load(v(31), at(GeneralRegister::STACK, 0x12345670)), &[0xd28a_ce10, 0xf2a2_4690, 0x3cf0_6bff]),
        // ldr q20, [x24, x10]
        (S4, &|x| x.load(v(12), Memory::Indexed { base: g(24), index: g(10) }), &[0x3cea_6b14]),
        // str q0, [x0, #0]
        (S4, &|x| x.store(at(g(0), 0x0), v(0)), &[0x3d80_0000]),
        // str q15, [x4, #65520]
        (S4, &|x| x.store(at(g(4), 0xfff0), v(29)), &[0x3dbf_fc8f]),
        // str q16, [sp, #16]
        (S4, &|x| x.store(at(GeneralRegister::STACK, 0x10), v(8)), &[0x3d80_07f0]),
        // movz x16, #0; movk x16, #1, lsl #16; str q3, [x15, x16]
        (S4, &|x| x.store(at(g(15), 0x10000), v(3)), &[0xd280_0010, 0xf2a0_0030, 0x3cb0_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; str q31, [sp, x16]
        (S4, &|x| x.store(at(GeneralRegister::STACK, 0x12345670), v(31)), &[0xd28a_ce10, 0xf2a2_4690, 0x3cb0_6bff]),
        // str q20, [x24, x10]
        (S4, &|x| x.store(Memory::Indexed { base: g(24), index: g(10) }, v(12)), &[0x3caa_6b14]),
        // ldr q31, [x0, #16]; fadd v2.4s, v1.4s, v31.4s
        (S4, &|x| x.binary(Binary::Add, v(2), v(1), Source::Memory(at(g(0), 16))),
            &[0x3dc0_041f, 0x4e3f_d422]),
        // ldr q0, [x0, #0]
        (D2, &|x| x.load(v(0), at(g(0), 0x0)), &[0x3dc0_0000]),
        // ldr q15, [x4, #65520]
        (D2, &|x| x.load(v(29), at(g(4), 0xfff0)), &[0x3dff_fc8f]),
        // ldr q16, [sp, #16]
        (D2, &|x| x.load(v(8), at(GeneralRegister::STACK, 0x10)), &[0x3dc0_07f0]),
        // movz x16, #0; movk x16, #1, lsl #16; ldr q3, [x15, x16]
        (D2, &|x| x.load(v(3), at(g(15), 0x10000)), &[0xd280_0010, 0xf2a0_0030, 0x3cf0_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; ldr q31, [sp, x16]
        (D2, &|x| x.load(v(31), at(GeneralRegister::STACK, 0x12345670)), &[0xd28a_ce10, 0xf2a2_4690, 0x3cf0_6bff]),
        // ldr q20, [x24, x10]
        (D2, &|x| x.load(v(12), Memory::Indexed { base: g(24), index: g(10) }), &[0x3cea_6b14]),
        // str q0, [x0, #0]
        (D2, &|x| x.store(at(g(0), 0x0), v(0)), &[0x3d80_0000]),
        // str q15, [x4, #65520]
        (D2, &|x| x.store(at(g(4), 0xfff0), v(29)), &[0x3dbf_fc8f]),
        // str q16, [sp, #16]
        (D2, &|x| x.store(at(GeneralRegister::STACK, 0x10), v(8)), &[0x3d80_07f0]),
        // movz x16, #0; movk x16, #1, lsl #16; str q3, [x15, x16]
        (D2, &|x| x.store(at(g(15), 0x10000), v(3)), &[0xd280_0010, 0xf2a0_0030, 0x3cb0_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; str q31, [sp, x16]
        (D2, &|x| x.store(at(GeneralRegister::STACK, 0x12345670), v(31)), &[0xd28a_ce10, 0xf2a2_4690, 0x3cb0_6bff]),
        // str q20, [x24, x10]
        (D2, &|x| x.store(Memory::Indexed { base: g(24), index: g(10) }, v(12)), &[0x3caa_6b14]),
        // ldr q31, [x0, #16]; fadd v2.2d, v1.2d, v31.2d
        (D2, &|x| x.binary(Binary::Add, v(2), v(1), Source::Memory(at(g(0), 16))),
            &[0x3dc0_041f, 0x4e7f_d422]),
    ]);
}

#[rustfmt::skip]
#[test]
fn addresses_and_counts_are_what_was_asked_for() {
    check(&[
        // mov x0, x1
        (D, &|x| x.move_general(g(0), g(1)), &[0xaa01_03e0]),
        // add x0, x0, x1
        (D, &|x| x.add_general(g(0), g(1)), &[0x8b01_0000]),
        // ldr x0, [x1, #8]
        (D, &|x| x.load_general(g(0), g(1), 8), &[0xf940_0420]),
        // movz x16, #0x8000; ldr x0, [x1, x16]
        (D, &|x| x.load_general(g(0), g(1), 0x8000), &[0xd290_0010, 0xf870_6820]),
        // movz x16, #8; movk x16, #6, lsl #16; ldr x0, [x1, x16]
        (D, &|x| x.load_general(g(0), g(1), 0x6_0008), &[0xd280_0110, 0xf2a0_00d0, 0xf870_6820]),
        // mov x0, #0
        (D, &|x| x.clear(g(0)), &[0xd280_0000]),
        // mov x15, x24
        (D, &|x| x.move_general(g(15), g(24)), &[0xaa18_03ef]),
        // add x15, x15, x24
        (D, &|x| x.add_general(g(15), g(24)), &[0x8b18_01ef]),
        // ldr x15, [x24, #8]
        (D, &|x| x.load_general(g(15), g(24), 8), &[0xf940_070f]),
        // movz x16, #0x8000; ldr x15, [x24, x16]
        (D, &|x| x.load_general(g(15), g(24), 0x8000), &[0xd290_0010, 0xf870_6b0f]),
        // movz x16, #8; movk x16, #6, lsl #16; ldr x15, [x24, x16]
        (D, &|x| x.load_general(g(15), g(24), 0x6_0008), &[0xd280_0110, 0xf2a0_00d0, 0xf870_6b0f]),
        // mov x15, #0
        (D, &|x| x.clear(g(15)), &[0xd280_000f]),
        // mov x19, x5
        (D, &|x| x.move_general(g(19), g(5)), &[0xaa05_03f3]),
        // add x19, x19, x5
        (D, &|x| x.add_general(g(19), g(5)), &[0x8b05_0273]),
        // ldr x19, [x5, #8]
        (D, &|x| x.load_general(g(19), g(5), 8), &[0xf940_04b3]),
        // movz x16, #0x8000; ldr x19, [x5, x16]
        (D, &|x| x.load_general(g(19), g(5), 0x8000), &[0xd290_0010, 0xf870_68b3]),
        // movz x16, #8; movk x16, #6, lsl #16; ldr x19, [x5, x16]
        (D, &|x| x.load_general(g(19), g(5), 0x6_0008), &[0xd280_0110, 0xf2a0_00d0, 0xf870_68b3]),
        // mov x19, #0
        (D, &|x| x.clear(g(19)), &[0xd280_0013]),
        // add x9, x9, #4
        (D, &|x| x.add_immediate(g(9), 4), &[0x9100_1129]),
        // add x9, x9, #8
        (D, &|x| x.add_immediate(g(9), 8), &[0x9100_2129]),
        // add x9, x9, #16
        (D, &|x| x.add_immediate(g(9), 16), &[0x9100_4129]),
        // add x9, x9, #4095
        (D, &|x| x.add_immediate(g(9), 4095), &[0x913f_fd29]),
    ]);
}
