//! Instructions against the words that the assembler of the GNU binutils makes of the text beside
//! them.

use super::general::{self, Forward};
use super::{Assembler, Binary, Element, Form, Fused, General, Memory, Needs, Order, Source, Vector, Width};

const fn form(element: Element, width: Width) -> Form {
    Form { element, width }
}

const S: Form = form(Element::Single, Width::Scalar);
const D: Form = form(Element::Double, Width::Scalar);
const S4: Form = form(Element::Single, Width::Bits128);
const D2: Form = form(Element::Double, Width::Bits128);

/// A form, what is written in it, and the words that it takes.
type Written<'a> = (Form, &'a dyn Fn(&mut Assembler), &'a [u32]);

fn v(register: u8) -> Vector {
    Vector(register)
}

fn r(register: u8) -> Source {
    Source::Register(v(register))
}

fn g(register: u8) -> General {
    let all = General::ARGUMENTS.into_iter().chain(General::SPARE).chain(General::POINTERS);
    all.into_iter().find(|known| known.number() == u32::from(register)).expect("it has a name")
}

fn at(base: General, offset: i32) -> Memory {
    Memory::At { base, offset }
}

fn words(bytes: &[u8]) -> Vec<u32> {
    assert!(bytes.len().is_multiple_of(4), "instructions are words");
    bytes.as_chunks().0.iter().map(|word| u32::from_le_bytes(*word)).collect()
}

fn check(all: &[Written<'_>]) {
    for (k, (form, write, expected)) in all.iter().enumerate() {
        let mut assembler = Assembler::new(*form);
        write(&mut assembler);
        let found = words(&assembler.bytes);
        assert_eq!(found, *expected, "{k} in {form:?}: {found:08x?}, not {expected:08x?}");
    }
}

/// A function that does nothing.
fn frame((stack, uses_pointers, vectors): (usize, bool, u8)) -> Vec<u32> {
    let needs = Needs { stack, uses_pointers, vectors, instructions: 1 };
    let mut assembler = Assembler::new(D);
    assembler.open(&needs);
    assembler.close(&needs);
    assert!(!assembler.is_long && assembler.form() == D);
    words(&assembler.bytes)
}

#[rustfmt::skip]
#[test]
fn operations_are_what_was_asked_for() {
    check(&[
        // fadd s0, s1, s2
        (S, &|x| x.binary(Binary::Add, v(0), v(1), r(2)), &[0x1e22_2820]),
        // fadd s16, s15, s29
        (S, &|x| x.binary(Binary::Add, v(8), v(29), r(21)), &[0x1e3d_29f0]),
        // fadd s15, s8, s7
        (S, &|x| x.binary(Binary::Add, v(29), v(22), r(7)), &[0x1e27_290f]),
        // fsub s0, s1, s2
        (S, &|x| x.binary(Binary::Subtract, v(0), v(1), r(2)), &[0x1e22_3820]),
        // fsub s16, s15, s29
        (S, &|x| x.binary(Binary::Subtract, v(8), v(29), r(21)), &[0x1e3d_39f0]),
        // fsub s15, s8, s7
        (S, &|x| x.binary(Binary::Subtract, v(29), v(22), r(7)), &[0x1e27_390f]),
        // fmul s0, s1, s2
        (S, &|x| x.binary(Binary::Multiply, v(0), v(1), r(2)), &[0x1e22_0820]),
        // fmul s16, s15, s29
        (S, &|x| x.binary(Binary::Multiply, v(8), v(29), r(21)), &[0x1e3d_09f0]),
        // fmul s15, s8, s7
        (S, &|x| x.binary(Binary::Multiply, v(29), v(22), r(7)), &[0x1e27_090f]),
        // fdiv s0, s1, s2
        (S, &|x| x.binary(Binary::Divide, v(0), v(1), r(2)), &[0x1e22_1820]),
        // fdiv s16, s15, s29
        (S, &|x| x.binary(Binary::Divide, v(8), v(29), r(21)), &[0x1e3d_19f0]),
        // fdiv s15, s8, s7
        (S, &|x| x.binary(Binary::Divide, v(29), v(22), r(7)), &[0x1e27_190f]),
        // fneg s17, s9
        (S, &|x| x.binary(Binary::ExclusiveOr, v(9), v(23), r(1)), &[0x1e21_4131]),
        // fmov s17, s9
        (S, &|x| x.copy(v(9), v(23)), &[0x1e20_4131]),
        // fmov s17, s9
        (S, &|x| x.round_to_single(v(9), v(23)), &[0x1e20_4131]),
        // fadd d0, d1, d2
        (D, &|x| x.binary(Binary::Add, v(0), v(1), r(2)), &[0x1e62_2820]),
        // fadd d16, d15, d29
        (D, &|x| x.binary(Binary::Add, v(8), v(29), r(21)), &[0x1e7d_29f0]),
        // fadd d15, d8, d7
        (D, &|x| x.binary(Binary::Add, v(29), v(22), r(7)), &[0x1e67_290f]),
        // fsub d0, d1, d2
        (D, &|x| x.binary(Binary::Subtract, v(0), v(1), r(2)), &[0x1e62_3820]),
        // fsub d16, d15, d29
        (D, &|x| x.binary(Binary::Subtract, v(8), v(29), r(21)), &[0x1e7d_39f0]),
        // fsub d15, d8, d7
        (D, &|x| x.binary(Binary::Subtract, v(29), v(22), r(7)), &[0x1e67_390f]),
        // fmul d0, d1, d2
        (D, &|x| x.binary(Binary::Multiply, v(0), v(1), r(2)), &[0x1e62_0820]),
        // fmul d16, d15, d29
        (D, &|x| x.binary(Binary::Multiply, v(8), v(29), r(21)), &[0x1e7d_09f0]),
        // fmul d15, d8, d7
        (D, &|x| x.binary(Binary::Multiply, v(29), v(22), r(7)), &[0x1e67_090f]),
        // fdiv d0, d1, d2
        (D, &|x| x.binary(Binary::Divide, v(0), v(1), r(2)), &[0x1e62_1820]),
        // fdiv d16, d15, d29
        (D, &|x| x.binary(Binary::Divide, v(8), v(29), r(21)), &[0x1e7d_19f0]),
        // fdiv d15, d8, d7
        (D, &|x| x.binary(Binary::Divide, v(29), v(22), r(7)), &[0x1e67_190f]),
        // fneg d17, d9
        (D, &|x| x.binary(Binary::ExclusiveOr, v(9), v(23), r(1)), &[0x1e61_4131]),
        // fmov d17, d9
        (D, &|x| x.copy(v(9), v(23)), &[0x1e60_4131]),
        // fcvt s17, d9; fcvt d17, s17
        (D, &|x| x.round_to_single(v(9), v(23)), &[0x1e62_4131, 0x1e22_c231]),
        // fadd v0.4s, v1.4s, v2.4s
        (S4, &|x| x.binary(Binary::Add, v(0), v(1), r(2)), &[0x4e22_d420]),
        // fadd v16.4s, v15.4s, v29.4s
        (S4, &|x| x.binary(Binary::Add, v(8), v(29), r(21)), &[0x4e3d_d5f0]),
        // fadd v15.4s, v8.4s, v7.4s
        (S4, &|x| x.binary(Binary::Add, v(29), v(22), r(7)), &[0x4e27_d50f]),
        // fsub v0.4s, v1.4s, v2.4s
        (S4, &|x| x.binary(Binary::Subtract, v(0), v(1), r(2)), &[0x4ea2_d420]),
        // fsub v16.4s, v15.4s, v29.4s
        (S4, &|x| x.binary(Binary::Subtract, v(8), v(29), r(21)), &[0x4ebd_d5f0]),
        // fsub v15.4s, v8.4s, v7.4s
        (S4, &|x| x.binary(Binary::Subtract, v(29), v(22), r(7)), &[0x4ea7_d50f]),
        // fmul v0.4s, v1.4s, v2.4s
        (S4, &|x| x.binary(Binary::Multiply, v(0), v(1), r(2)), &[0x6e22_dc20]),
        // fmul v16.4s, v15.4s, v29.4s
        (S4, &|x| x.binary(Binary::Multiply, v(8), v(29), r(21)), &[0x6e3d_ddf0]),
        // fmul v15.4s, v8.4s, v7.4s
        (S4, &|x| x.binary(Binary::Multiply, v(29), v(22), r(7)), &[0x6e27_dd0f]),
        // fdiv v0.4s, v1.4s, v2.4s
        (S4, &|x| x.binary(Binary::Divide, v(0), v(1), r(2)), &[0x6e22_fc20]),
        // fdiv v16.4s, v15.4s, v29.4s
        (S4, &|x| x.binary(Binary::Divide, v(8), v(29), r(21)), &[0x6e3d_fdf0]),
        // fdiv v15.4s, v8.4s, v7.4s
        (S4, &|x| x.binary(Binary::Divide, v(29), v(22), r(7)), &[0x6e27_fd0f]),
        // fneg v17.4s, v9.4s
        (S4, &|x| x.binary(Binary::ExclusiveOr, v(9), v(23), r(1)), &[0x6ea0_f931]),
        // mov v17.16b, v9.16b
        (S4, &|x| x.copy(v(9), v(23)), &[0x4ea9_1d31]),
        // mov v17.16b, v9.16b
        (S4, &|x| x.round_to_single(v(9), v(23)), &[0x4ea9_1d31]),
        // fadd v0.2d, v1.2d, v2.2d
        (D2, &|x| x.binary(Binary::Add, v(0), v(1), r(2)), &[0x4e62_d420]),
        // fadd v16.2d, v15.2d, v29.2d
        (D2, &|x| x.binary(Binary::Add, v(8), v(29), r(21)), &[0x4e7d_d5f0]),
        // fadd v15.2d, v8.2d, v7.2d
        (D2, &|x| x.binary(Binary::Add, v(29), v(22), r(7)), &[0x4e67_d50f]),
        // fsub v0.2d, v1.2d, v2.2d
        (D2, &|x| x.binary(Binary::Subtract, v(0), v(1), r(2)), &[0x4ee2_d420]),
        // fsub v16.2d, v15.2d, v29.2d
        (D2, &|x| x.binary(Binary::Subtract, v(8), v(29), r(21)), &[0x4efd_d5f0]),
        // fsub v15.2d, v8.2d, v7.2d
        (D2, &|x| x.binary(Binary::Subtract, v(29), v(22), r(7)), &[0x4ee7_d50f]),
        // fmul v0.2d, v1.2d, v2.2d
        (D2, &|x| x.binary(Binary::Multiply, v(0), v(1), r(2)), &[0x6e62_dc20]),
        // fmul v16.2d, v15.2d, v29.2d
        (D2, &|x| x.binary(Binary::Multiply, v(8), v(29), r(21)), &[0x6e7d_ddf0]),
        // fmul v15.2d, v8.2d, v7.2d
        (D2, &|x| x.binary(Binary::Multiply, v(29), v(22), r(7)), &[0x6e67_dd0f]),
        // fdiv v0.2d, v1.2d, v2.2d
        (D2, &|x| x.binary(Binary::Divide, v(0), v(1), r(2)), &[0x6e62_fc20]),
        // fdiv v16.2d, v15.2d, v29.2d
        (D2, &|x| x.binary(Binary::Divide, v(8), v(29), r(21)), &[0x6e7d_fdf0]),
        // fdiv v15.2d, v8.2d, v7.2d
        (D2, &|x| x.binary(Binary::Divide, v(29), v(22), r(7)), &[0x6e67_fd0f]),
        // fneg v17.2d, v9.2d
        (D2, &|x| x.binary(Binary::ExclusiveOr, v(9), v(23), r(1)), &[0x6ee0_f931]),
        // mov v17.16b, v9.16b
        (D2, &|x| x.copy(v(9), v(23)), &[0x4ea9_1d31]),
        // fcvtn v17.2s, v9.2d; fcvtl v17.2d, v17.2s
        (D2, &|x| x.round_to_single(v(9), v(23)), &[0x0e61_6931, 0x0e61_7a31]),
    ]);
}

#[rustfmt::skip]
#[test]
fn a_larger_number_is_one_that_is_greater() {
    check(&[
        // fcmp s1, s9; fcsel s17, s1, s9, gt
        (S, &|x| x.binary(Binary::Maximum, v(9), v(1), r(23)), &[0x1e29_2020, 0x1e29_cc31]),
        // fcmp s17, s9; fcsel s17, s17, s9, gt
        (S, &|x| x.binary(Binary::Maximum, v(9), v(9), r(23)), &[0x1e29_2220, 0x1e29_ce31]),
        // fcmp s9, s17; fcsel s17, s9, s17, gt
        (S, &|x| x.binary(Binary::Maximum, v(9), v(23), r(9)), &[0x1e31_2120, 0x1e31_cd31]),
        // fcmp s17, s17; fcsel s17, s17, s17, gt
        (S, &|x| x.binary(Binary::Maximum, v(9), v(9), r(9)), &[0x1e31_2220, 0x1e31_ce31]),
        // fcmp s1, s9; fcsel s17, s1, s9, mi
        (S, &|x| x.binary(Binary::Minimum, v(9), v(1), r(23)), &[0x1e29_2020, 0x1e29_4c31]),
        // fcmp s17, s9; fcsel s17, s17, s9, mi
        (S, &|x| x.binary(Binary::Minimum, v(9), v(9), r(23)), &[0x1e29_2220, 0x1e29_4e31]),
        // fcmp s9, s17; fcsel s17, s9, s17, mi
        (S, &|x| x.binary(Binary::Minimum, v(9), v(23), r(9)), &[0x1e31_2120, 0x1e31_4d31]),
        // fcmp s17, s17; fcsel s17, s17, s17, mi
        (S, &|x| x.binary(Binary::Minimum, v(9), v(9), r(9)), &[0x1e31_2220, 0x1e31_4e31]),
        // fcmp d1, d9; fcsel d17, d1, d9, gt
        (D, &|x| x.binary(Binary::Maximum, v(9), v(1), r(23)), &[0x1e69_2020, 0x1e69_cc31]),
        // fcmp d17, d9; fcsel d17, d17, d9, gt
        (D, &|x| x.binary(Binary::Maximum, v(9), v(9), r(23)), &[0x1e69_2220, 0x1e69_ce31]),
        // fcmp d9, d17; fcsel d17, d9, d17, gt
        (D, &|x| x.binary(Binary::Maximum, v(9), v(23), r(9)), &[0x1e71_2120, 0x1e71_cd31]),
        // fcmp d17, d17; fcsel d17, d17, d17, gt
        (D, &|x| x.binary(Binary::Maximum, v(9), v(9), r(9)), &[0x1e71_2220, 0x1e71_ce31]),
        // fcmp d1, d9; fcsel d17, d1, d9, mi
        (D, &|x| x.binary(Binary::Minimum, v(9), v(1), r(23)), &[0x1e69_2020, 0x1e69_4c31]),
        // fcmp d17, d9; fcsel d17, d17, d9, mi
        (D, &|x| x.binary(Binary::Minimum, v(9), v(9), r(23)), &[0x1e69_2220, 0x1e69_4e31]),
        // fcmp d9, d17; fcsel d17, d9, d17, mi
        (D, &|x| x.binary(Binary::Minimum, v(9), v(23), r(9)), &[0x1e71_2120, 0x1e71_4d31]),
        // fcmp d17, d17; fcsel d17, d17, d17, mi
        (D, &|x| x.binary(Binary::Minimum, v(9), v(9), r(9)), &[0x1e71_2220, 0x1e71_4e31]),
        // fcmgt v17.4s, v1.4s, v9.4s; bsl v17.16b, v1.16b, v9.16b
        (S4, &|x| x.binary(Binary::Maximum, v(9), v(1), r(23)), &[0x6ea9_e431, 0x6e69_1c31]),
        // fcmgt v30.4s, v17.4s, v9.4s; bif v17.16b, v9.16b, v30.16b
        (S4, &|x| x.binary(Binary::Maximum, v(9), v(9), r(23)), &[0x6ea9_e63e, 0x6efe_1d31]),
        // fcmgt v30.4s, v9.4s, v17.4s; bit v17.16b, v9.16b, v30.16b
        (S4, &|x| x.binary(Binary::Maximum, v(9), v(23), r(9)), &[0x6eb1_e53e, 0x6ebe_1d31]),
        // fcmgt v30.4s, v17.4s, v17.4s; bit v17.16b, v17.16b, v30.16b
        (S4, &|x| x.binary(Binary::Maximum, v(9), v(9), r(9)), &[0x6eb1_e63e, 0x6ebe_1e31]),
        // fcmgt v17.4s, v9.4s, v1.4s; bsl v17.16b, v1.16b, v9.16b
        (S4, &|x| x.binary(Binary::Minimum, v(9), v(1), r(23)), &[0x6ea1_e531, 0x6e69_1c31]),
        // fcmgt v30.4s, v9.4s, v17.4s; bif v17.16b, v9.16b, v30.16b
        (S4, &|x| x.binary(Binary::Minimum, v(9), v(9), r(23)), &[0x6eb1_e53e, 0x6efe_1d31]),
        // fcmgt v30.4s, v17.4s, v9.4s; bit v17.16b, v9.16b, v30.16b
        (S4, &|x| x.binary(Binary::Minimum, v(9), v(23), r(9)), &[0x6ea9_e63e, 0x6ebe_1d31]),
        // fcmgt v30.4s, v17.4s, v17.4s; bit v17.16b, v17.16b, v30.16b
        (S4, &|x| x.binary(Binary::Minimum, v(9), v(9), r(9)), &[0x6eb1_e63e, 0x6ebe_1e31]),
        // fcmgt v17.2d, v1.2d, v9.2d; bsl v17.16b, v1.16b, v9.16b
        (D2, &|x| x.binary(Binary::Maximum, v(9), v(1), r(23)), &[0x6ee9_e431, 0x6e69_1c31]),
        // fcmgt v30.2d, v17.2d, v9.2d; bif v17.16b, v9.16b, v30.16b
        (D2, &|x| x.binary(Binary::Maximum, v(9), v(9), r(23)), &[0x6ee9_e63e, 0x6efe_1d31]),
        // fcmgt v30.2d, v9.2d, v17.2d; bit v17.16b, v9.16b, v30.16b
        (D2, &|x| x.binary(Binary::Maximum, v(9), v(23), r(9)), &[0x6ef1_e53e, 0x6ebe_1d31]),
        // fcmgt v30.2d, v17.2d, v17.2d; bit v17.16b, v17.16b, v30.16b
        (D2, &|x| x.binary(Binary::Maximum, v(9), v(9), r(9)), &[0x6ef1_e63e, 0x6ebe_1e31]),
        // fcmgt v17.2d, v9.2d, v1.2d; bsl v17.16b, v1.16b, v9.16b
        (D2, &|x| x.binary(Binary::Minimum, v(9), v(1), r(23)), &[0x6ee1_e531, 0x6e69_1c31]),
        // fcmgt v30.2d, v9.2d, v17.2d; bif v17.16b, v9.16b, v30.16b
        (D2, &|x| x.binary(Binary::Minimum, v(9), v(9), r(23)), &[0x6ef1_e53e, 0x6efe_1d31]),
        // fcmgt v30.2d, v17.2d, v9.2d; bit v17.16b, v9.16b, v30.16b
        (D2, &|x| x.binary(Binary::Minimum, v(9), v(23), r(9)), &[0x6ee9_e63e, 0x6ebe_1d31]),
        // fcmgt v30.2d, v17.2d, v17.2d; bit v17.16b, v17.16b, v30.16b
        (D2, &|x| x.binary(Binary::Minimum, v(9), v(9), r(9)), &[0x6ef1_e63e, 0x6ebe_1e31]),
    ]);
}

#[rustfmt::skip]
#[test]
fn fused_operations_are_what_was_asked_for() {
    check(&[
        // fmadd s17, s17, s9, s1
        (S, &|x| x.fused(Fused::MultiplyAdd, Order::D132, v(9), v(1), r(23)), &[0x1f09_0631]),
        // fmadd s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplyAdd, Order::D132, v(9), v(9), r(9)), &[0x1f11_4631]),
        // fmadd s17, s1, s17, s9
        (S, &|x| x.fused(Fused::MultiplyAdd, Order::D213, v(9), v(1), r(23)), &[0x1f11_2431]),
        // fmadd s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplyAdd, Order::D213, v(9), v(9), r(9)), &[0x1f11_4631]),
        // fmadd s17, s1, s9, s17
        (S, &|x| x.fused(Fused::MultiplyAdd, Order::D231, v(9), v(1), r(23)), &[0x1f09_4431]),
        // fmadd s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplyAdd, Order::D231, v(9), v(9), r(9)), &[0x1f11_4631]),
        // fnmsub s17, s17, s9, s1
        (S, &|x| x.fused(Fused::MultiplySubtract, Order::D132, v(9), v(1), r(23)), &[0x1f29_8631]),
        // fnmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplySubtract, Order::D132, v(9), v(9), r(9)), &[0x1f31_c631]),
        // fnmsub s17, s1, s17, s9
        (S, &|x| x.fused(Fused::MultiplySubtract, Order::D213, v(9), v(1), r(23)), &[0x1f31_a431]),
        // fnmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplySubtract, Order::D213, v(9), v(9), r(9)), &[0x1f31_c631]),
        // fnmsub s17, s1, s9, s17
        (S, &|x| x.fused(Fused::MultiplySubtract, Order::D231, v(9), v(1), r(23)), &[0x1f29_c431]),
        // fnmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplySubtract, Order::D231, v(9), v(9), r(9)), &[0x1f31_c631]),
        // fmsub s17, s17, s9, s1
        (S, &|x| x.fused(Fused::SubtractProduct, Order::D132, v(9), v(1), r(23)), &[0x1f09_8631]),
        // fmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::SubtractProduct, Order::D132, v(9), v(9), r(9)), &[0x1f11_c631]),
        // fmsub s17, s1, s17, s9
        (S, &|x| x.fused(Fused::SubtractProduct, Order::D213, v(9), v(1), r(23)), &[0x1f11_a431]),
        // fmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::SubtractProduct, Order::D213, v(9), v(9), r(9)), &[0x1f11_c631]),
        // fmsub s17, s1, s9, s17
        (S, &|x| x.fused(Fused::SubtractProduct, Order::D231, v(9), v(1), r(23)), &[0x1f09_c431]),
        // fmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::SubtractProduct, Order::D231, v(9), v(9), r(9)), &[0x1f11_c631]),
        // fmadd d17, d17, d9, d1
        (D, &|x| x.fused(Fused::MultiplyAdd, Order::D132, v(9), v(1), r(23)), &[0x1f49_0631]),
        // fmadd d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplyAdd, Order::D132, v(9), v(9), r(9)), &[0x1f51_4631]),
        // fmadd d17, d1, d17, d9
        (D, &|x| x.fused(Fused::MultiplyAdd, Order::D213, v(9), v(1), r(23)), &[0x1f51_2431]),
        // fmadd d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplyAdd, Order::D213, v(9), v(9), r(9)), &[0x1f51_4631]),
        // fmadd d17, d1, d9, d17
        (D, &|x| x.fused(Fused::MultiplyAdd, Order::D231, v(9), v(1), r(23)), &[0x1f49_4431]),
        // fmadd d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplyAdd, Order::D231, v(9), v(9), r(9)), &[0x1f51_4631]),
        // fnmsub d17, d17, d9, d1
        (D, &|x| x.fused(Fused::MultiplySubtract, Order::D132, v(9), v(1), r(23)), &[0x1f69_8631]),
        // fnmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplySubtract, Order::D132, v(9), v(9), r(9)), &[0x1f71_c631]),
        // fnmsub d17, d1, d17, d9
        (D, &|x| x.fused(Fused::MultiplySubtract, Order::D213, v(9), v(1), r(23)), &[0x1f71_a431]),
        // fnmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplySubtract, Order::D213, v(9), v(9), r(9)), &[0x1f71_c631]),
        // fnmsub d17, d1, d9, d17
        (D, &|x| x.fused(Fused::MultiplySubtract, Order::D231, v(9), v(1), r(23)), &[0x1f69_c431]),
        // fnmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplySubtract, Order::D231, v(9), v(9), r(9)), &[0x1f71_c631]),
        // fmsub d17, d17, d9, d1
        (D, &|x| x.fused(Fused::SubtractProduct, Order::D132, v(9), v(1), r(23)), &[0x1f49_8631]),
        // fmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::SubtractProduct, Order::D132, v(9), v(9), r(9)), &[0x1f51_c631]),
        // fmsub d17, d1, d17, d9
        (D, &|x| x.fused(Fused::SubtractProduct, Order::D213, v(9), v(1), r(23)), &[0x1f51_a431]),
        // fmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::SubtractProduct, Order::D213, v(9), v(9), r(9)), &[0x1f51_c631]),
        // fmsub d17, d1, d9, d17
        (D, &|x| x.fused(Fused::SubtractProduct, Order::D231, v(9), v(1), r(23)), &[0x1f49_c431]),
        // fmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::SubtractProduct, Order::D231, v(9), v(9), r(9)), &[0x1f51_c631]),
        // mov v30.16b, v1.16b; fmla v30.4s, v17.4s, v9.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplyAdd, Order::D132, v(9), v(1), r(23)), &[0x4ea1_1c3e, 0x4e29_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplyAdd, Order::D132, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v9.16b; fmla v30.4s, v1.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplyAdd, Order::D213, v(9), v(1), r(23)), &[0x4ea9_1d3e, 0x4e31_cc3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplyAdd, Order::D213, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // fmla v17.4s, v1.4s, v9.4s
        (S4, &|x| x.fused(Fused::MultiplyAdd, Order::D231, v(9), v(1), r(23)), &[0x4e29_cc31]),
        // mov v30.16b, v17.16b; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplyAdd, Order::D231, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // fneg v30.4s, v1.4s; fmla v30.4s, v17.4s, v9.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplySubtract, Order::D132, v(9), v(1), r(23)), &[0x6ea0_f83e, 0x4e29_ce3e, 0x4ebe_1fd1]),
        // fneg v30.4s, v17.4s; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplySubtract, Order::D132, v(9), v(9), r(9)), &[0x6ea0_fa3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // fneg v30.4s, v9.4s; fmla v30.4s, v1.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplySubtract, Order::D213, v(9), v(1), r(23)), &[0x6ea0_f93e, 0x4e31_cc3e, 0x4ebe_1fd1]),
        // fneg v30.4s, v17.4s; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplySubtract, Order::D213, v(9), v(9), r(9)), &[0x6ea0_fa3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // fneg v17.4s, v17.4s; fmla v17.4s, v1.4s, v9.4s
        (S4, &|x| x.fused(Fused::MultiplySubtract, Order::D231, v(9), v(1), r(23)), &[0x6ea0_fa31, 0x4e29_cc31]),
        // fneg v30.4s, v17.4s; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplySubtract, Order::D231, v(9), v(9), r(9)), &[0x6ea0_fa3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v1.16b; fmls v30.4s, v17.4s, v9.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::SubtractProduct, Order::D132, v(9), v(1), r(23)), &[0x4ea1_1c3e, 0x4ea9_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmls v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::SubtractProduct, Order::D132, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4eb1_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v9.16b; fmls v30.4s, v1.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::SubtractProduct, Order::D213, v(9), v(1), r(23)), &[0x4ea9_1d3e, 0x4eb1_cc3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmls v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::SubtractProduct, Order::D213, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4eb1_ce3e, 0x4ebe_1fd1]),
        // fmls v17.4s, v1.4s, v9.4s
        (S4, &|x| x.fused(Fused::SubtractProduct, Order::D231, v(9), v(1), r(23)), &[0x4ea9_cc31]),
        // mov v30.16b, v17.16b; fmls v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::SubtractProduct, Order::D231, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4eb1_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v1.16b; fmla v30.2d, v17.2d, v9.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplyAdd, Order::D132, v(9), v(1), r(23)), &[0x4ea1_1c3e, 0x4e69_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplyAdd, Order::D132, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v9.16b; fmla v30.2d, v1.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplyAdd, Order::D213, v(9), v(1), r(23)), &[0x4ea9_1d3e, 0x4e71_cc3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplyAdd, Order::D213, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // fmla v17.2d, v1.2d, v9.2d
        (D2, &|x| x.fused(Fused::MultiplyAdd, Order::D231, v(9), v(1), r(23)), &[0x4e69_cc31]),
        // mov v30.16b, v17.16b; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplyAdd, Order::D231, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // fneg v30.2d, v1.2d; fmla v30.2d, v17.2d, v9.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplySubtract, Order::D132, v(9), v(1), r(23)), &[0x6ee0_f83e, 0x4e69_ce3e, 0x4ebe_1fd1]),
        // fneg v30.2d, v17.2d; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplySubtract, Order::D132, v(9), v(9), r(9)), &[0x6ee0_fa3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // fneg v30.2d, v9.2d; fmla v30.2d, v1.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplySubtract, Order::D213, v(9), v(1), r(23)), &[0x6ee0_f93e, 0x4e71_cc3e, 0x4ebe_1fd1]),
        // fneg v30.2d, v17.2d; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplySubtract, Order::D213, v(9), v(9), r(9)), &[0x6ee0_fa3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // fneg v17.2d, v17.2d; fmla v17.2d, v1.2d, v9.2d
        (D2, &|x| x.fused(Fused::MultiplySubtract, Order::D231, v(9), v(1), r(23)), &[0x6ee0_fa31, 0x4e69_cc31]),
        // fneg v30.2d, v17.2d; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplySubtract, Order::D231, v(9), v(9), r(9)), &[0x6ee0_fa3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v1.16b; fmls v30.2d, v17.2d, v9.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::SubtractProduct, Order::D132, v(9), v(1), r(23)), &[0x4ea1_1c3e, 0x4ee9_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmls v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::SubtractProduct, Order::D132, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4ef1_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v9.16b; fmls v30.2d, v1.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::SubtractProduct, Order::D213, v(9), v(1), r(23)), &[0x4ea9_1d3e, 0x4ef1_cc3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmls v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::SubtractProduct, Order::D213, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4ef1_ce3e, 0x4ebe_1fd1]),
        // fmls v17.2d, v1.2d, v9.2d
        (D2, &|x| x.fused(Fused::SubtractProduct, Order::D231, v(9), v(1), r(23)), &[0x4ee9_cc31]),
        // mov v30.16b, v17.16b; fmls v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::SubtractProduct, Order::D231, v(9), v(9), r(9)), &[0x4eb1_1e3e, 0x4ef1_ce3e, 0x4ebe_1fd1]),
    ]);
}

#[rustfmt::skip]
#[test]
fn numbers_are_loaded_and_stored_wherever_they_lie() {
    check(&[
        // ldr s0, [x0, #0]
        (S, &|x| x.load(v(0), at(g(0), 0x0)), &[0xbd40_0000]),
        // ldr s15, [x4, #16380]
        (S, &|x| x.load(v(29), at(g(4), 0x3ffc)), &[0xbd7f_fc8f]),
        // ldr s16, [sp, #4]
        (S, &|x| x.load(v(8), at(General::STACK, 0x4)), &[0xbd40_07f0]),
        // movz x16, #16384; ldr s3, [x15, x16]
        (S, &|x| x.load(v(3), at(g(15), 0x4000)), &[0xd288_0010, 0xbc70_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; ldr s31, [sp, x16]
        (S, &|x| x.load(v(31), at(General::STACK, 0x12345670)), &[0xd28a_ce10, 0xf2a2_4690, 0xbc70_6bff]),
        // ldr s20, [x24, x10]
        (S, &|x| x.load(v(12), Memory::Indexed { base: g(24), index: g(10) }), &[0xbc6a_6b14]),
        // str s0, [x0, #0]
        (S, &|x| x.store(at(g(0), 0x0), v(0)), &[0xbd00_0000]),
        // str s15, [x4, #16380]
        (S, &|x| x.store(at(g(4), 0x3ffc), v(29)), &[0xbd3f_fc8f]),
        // str s16, [sp, #4]
        (S, &|x| x.store(at(General::STACK, 0x4), v(8)), &[0xbd00_07f0]),
        // movz x16, #16384; str s3, [x15, x16]
        (S, &|x| x.store(at(g(15), 0x4000), v(3)), &[0xd288_0010, 0xbc30_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; str s31, [sp, x16]
        (S, &|x| x.store(at(General::STACK, 0x12345670), v(31)), &[0xd28a_ce10, 0xf2a2_4690, 0xbc30_6bff]),
        // str s20, [x24, x10]
        (S, &|x| x.store(Memory::Indexed { base: g(24), index: g(10) }, v(12)), &[0xbc2a_6b14]),
        // ldr s31, [x0, #4]; fadd s2, s1, s31
        (S, &|x| x.binary(Binary::Add, v(2), v(1), Source::Memory(at(g(0), 4))), &[0xbd40_041f, 0x1e3f_2822]),
        // ldr d0, [x0, #0]
        (D, &|x| x.load(v(0), at(g(0), 0x0)), &[0xfd40_0000]),
        // ldr d15, [x4, #32760]
        (D, &|x| x.load(v(29), at(g(4), 0x7ff8)), &[0xfd7f_fc8f]),
        // ldr d16, [sp, #8]
        (D, &|x| x.load(v(8), at(General::STACK, 0x8)), &[0xfd40_07f0]),
        // movz x16, #32768; ldr d3, [x15, x16]
        (D, &|x| x.load(v(3), at(g(15), 0x8000)), &[0xd290_0010, 0xfc70_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; ldr d31, [sp, x16]
        (D, &|x| x.load(v(31), at(General::STACK, 0x12345670)), &[0xd28a_ce10, 0xf2a2_4690, 0xfc70_6bff]),
        // ldr d20, [x24, x10]
        (D, &|x| x.load(v(12), Memory::Indexed { base: g(24), index: g(10) }), &[0xfc6a_6b14]),
        // str d0, [x0, #0]
        (D, &|x| x.store(at(g(0), 0x0), v(0)), &[0xfd00_0000]),
        // str d15, [x4, #32760]
        (D, &|x| x.store(at(g(4), 0x7ff8), v(29)), &[0xfd3f_fc8f]),
        // str d16, [sp, #8]
        (D, &|x| x.store(at(General::STACK, 0x8), v(8)), &[0xfd00_07f0]),
        // movz x16, #32768; str d3, [x15, x16]
        (D, &|x| x.store(at(g(15), 0x8000), v(3)), &[0xd290_0010, 0xfc30_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; str d31, [sp, x16]
        (D, &|x| x.store(at(General::STACK, 0x12345670), v(31)), &[0xd28a_ce10, 0xf2a2_4690, 0xfc30_6bff]),
        // str d20, [x24, x10]
        (D, &|x| x.store(Memory::Indexed { base: g(24), index: g(10) }, v(12)), &[0xfc2a_6b14]),
        // ldr d31, [x0, #8]; fadd d2, d1, d31
        (D, &|x| x.binary(Binary::Add, v(2), v(1), Source::Memory(at(g(0), 8))), &[0xfd40_041f, 0x1e7f_2822]),
        // ldr q0, [x0, #0]
        (S4, &|x| x.load(v(0), at(g(0), 0x0)), &[0x3dc0_0000]),
        // ldr q15, [x4, #65520]
        (S4, &|x| x.load(v(29), at(g(4), 0xfff0)), &[0x3dff_fc8f]),
        // ldr q16, [sp, #16]
        (S4, &|x| x.load(v(8), at(General::STACK, 0x10)), &[0x3dc0_07f0]),
        // movz x16, #0; movk x16, #1, lsl #16; ldr q3, [x15, x16]
        (S4, &|x| x.load(v(3), at(g(15), 0x10000)), &[0xd280_0010, 0xf2a0_0030, 0x3cf0_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; ldr q31, [sp, x16]
        (S4, &|x| x.load(v(31), at(General::STACK, 0x12345670)), &[0xd28a_ce10, 0xf2a2_4690, 0x3cf0_6bff]),
        // ldr q20, [x24, x10]
        (S4, &|x| x.load(v(12), Memory::Indexed { base: g(24), index: g(10) }), &[0x3cea_6b14]),
        // str q0, [x0, #0]
        (S4, &|x| x.store(at(g(0), 0x0), v(0)), &[0x3d80_0000]),
        // str q15, [x4, #65520]
        (S4, &|x| x.store(at(g(4), 0xfff0), v(29)), &[0x3dbf_fc8f]),
        // str q16, [sp, #16]
        (S4, &|x| x.store(at(General::STACK, 0x10), v(8)), &[0x3d80_07f0]),
        // movz x16, #0; movk x16, #1, lsl #16; str q3, [x15, x16]
        (S4, &|x| x.store(at(g(15), 0x10000), v(3)), &[0xd280_0010, 0xf2a0_0030, 0x3cb0_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; str q31, [sp, x16]
        (S4, &|x| x.store(at(General::STACK, 0x12345670), v(31)), &[0xd28a_ce10, 0xf2a2_4690, 0x3cb0_6bff]),
        // str q20, [x24, x10]
        (S4, &|x| x.store(Memory::Indexed { base: g(24), index: g(10) }, v(12)), &[0x3caa_6b14]),
        // ldr q31, [x0, #16]; fadd v2.4s, v1.4s, v31.4s
        (S4, &|x| x.binary(Binary::Add, v(2), v(1), Source::Memory(at(g(0), 16))), &[0x3dc0_041f, 0x4e3f_d422]),
        // ldr q0, [x0, #0]
        (D2, &|x| x.load(v(0), at(g(0), 0x0)), &[0x3dc0_0000]),
        // ldr q15, [x4, #65520]
        (D2, &|x| x.load(v(29), at(g(4), 0xfff0)), &[0x3dff_fc8f]),
        // ldr q16, [sp, #16]
        (D2, &|x| x.load(v(8), at(General::STACK, 0x10)), &[0x3dc0_07f0]),
        // movz x16, #0; movk x16, #1, lsl #16; ldr q3, [x15, x16]
        (D2, &|x| x.load(v(3), at(g(15), 0x10000)), &[0xd280_0010, 0xf2a0_0030, 0x3cf0_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; ldr q31, [sp, x16]
        (D2, &|x| x.load(v(31), at(General::STACK, 0x12345670)), &[0xd28a_ce10, 0xf2a2_4690, 0x3cf0_6bff]),
        // ldr q20, [x24, x10]
        (D2, &|x| x.load(v(12), Memory::Indexed { base: g(24), index: g(10) }), &[0x3cea_6b14]),
        // str q0, [x0, #0]
        (D2, &|x| x.store(at(g(0), 0x0), v(0)), &[0x3d80_0000]),
        // str q15, [x4, #65520]
        (D2, &|x| x.store(at(g(4), 0xfff0), v(29)), &[0x3dbf_fc8f]),
        // str q16, [sp, #16]
        (D2, &|x| x.store(at(General::STACK, 0x10), v(8)), &[0x3d80_07f0]),
        // movz x16, #0; movk x16, #1, lsl #16; str q3, [x15, x16]
        (D2, &|x| x.store(at(g(15), 0x10000), v(3)), &[0xd280_0010, 0xf2a0_0030, 0x3cb0_69e3]),
        // movz x16, #22128; movk x16, #4660, lsl #16; str q31, [sp, x16]
        (D2, &|x| x.store(at(General::STACK, 0x12345670), v(31)), &[0xd28a_ce10, 0xf2a2_4690, 0x3cb0_6bff]),
        // str q20, [x24, x10]
        (D2, &|x| x.store(Memory::Indexed { base: g(24), index: g(10) }, v(12)), &[0x3caa_6b14]),
        // ldr q31, [x0, #16]; fadd v2.2d, v1.2d, v31.2d
        (D2, &|x| x.binary(Binary::Add, v(2), v(1), Source::Memory(at(g(0), 16))), &[0x3dc0_041f, 0x4e7f_d422]),
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

#[rustfmt::skip]
#[test]
fn a_function_leaves_the_registers_of_its_caller_as_they_were() {
    let frames: &[((usize, bool, u8), &[u32])] = &[
        // ret
        ((0, false, 22), &[0xd65f_03c0]),
        // stp x29, x30, [sp, #-32]!; mov x29, sp; stp d8, d9, [sp, #16]; ldp d8, d9, [sp, #16]; ldp x29, x30, [sp], #32; ret
        ((0, false, 23), &[0xa9be_7bfd, 0x9100_03fd, 0x6d01_27e8, 0x6d41_27e8, 0xa8c2_7bfd, 0xd65f_03c0]),
        // stp x29, x30, [sp, #-128]!; mov x29, sp; stp d8, d9, [sp, #16]; stp d10, d11, [sp, #32]; stp d12, d13, [sp, #48]; stp d14, d15, [sp, #64]; stp x19, x20, [sp, #80]; stp x21, x22, [sp, #96]; stp x23, x24, [sp, #112]; ldp d8, d9, [sp, #16]; ldp d10, d11, [sp, #32]; ldp d12, d13, [sp, #48]; ldp d14, d15, [sp, #64]; ldp x19, x20, [sp, #80]; ldp x21, x22, [sp, #96]; ldp x23, x24, [sp, #112]; ldp x29, x30, [sp], #128; ret
        ((0, true, 30), &[0xa9b8_7bfd, 0x9100_03fd, 0x6d01_27e8, 0x6d02_2fea, 0x6d03_37ec, 0x6d04_3fee, 0xa905_53f3, 0xa906_5bf5, 0xa907_63f7, 0x6d41_27e8, 0x6d42_2fea, 0x6d43_37ec, 0x6d44_3fee, 0xa945_53f3, 0xa946_5bf5, 0xa947_63f7, 0xa8c8_7bfd, 0xd65f_03c0]),
        // stp x29, x30, [sp, #-16]!; mov x29, sp; sub sp, sp, #16; str xzr, [sp]; mov sp, x29; ldp x29, x30, [sp], #16; ret
        ((8, false, 3), &[0xa9bf_7bfd, 0x9100_03fd, 0xd100_43ff, 0xf900_03ff, 0x9100_03bf, 0xa8c1_7bfd, 0xd65f_03c0]),
        // stp x29, x30, [sp, #-96]!; mov x29, sp; stp d8, d9, [sp, #16]; stp d10, d11, [sp, #32]; stp x19, x20, [sp, #48]; stp x21, x22, [sp, #64]; stp x23, x24, [sp, #80]; sub sp, sp, #4096; str xzr, [sp]; sub sp, sp, #4096; str xzr, [sp]; sub sp, sp, #816; str xzr, [sp]; mov sp, x29; ldp d8, d9, [sp, #16]; ldp d10, d11, [sp, #32]; ldp x19, x20, [sp, #48]; ldp x21, x22, [sp, #64]; ldp x23, x24, [sp, #80]; ldp x29, x30, [sp], #96; ret
        ((9000, true, 25), &[0xa9ba_7bfd, 0x9100_03fd, 0x6d01_27e8, 0x6d02_2fea, 0xa903_53f3, 0xa904_5bf5, 0xa905_63f7, 0xd140_07ff, 0xf900_03ff, 0xd140_07ff, 0xf900_03ff, 0xd10c_c3ff, 0xf900_03ff, 0x9100_03bf, 0x6d41_27e8, 0x6d42_2fea, 0xa943_53f3, 0xa944_5bf5, 0xa945_63f7, 0xa8c6_7bfd, 0xd65f_03c0]),
        // stp x29, x30, [sp, #-32]!; mov x29, sp; stp d8, d9, [sp, #16]; sub sp, sp, #4096; str xzr, [sp]; mov sp, x29; ldp d8, d9, [sp, #16]; ldp x29, x30, [sp], #32; ret
        ((4096, false, 24), &[0xa9be_7bfd, 0x9100_03fd, 0x6d01_27e8, 0xd140_07ff, 0xf900_03ff, 0x9100_03bf, 0x6d41_27e8, 0xa8c2_7bfd, 0xd65f_03c0]),
    ];
    for (needs, expected) in frames {
        assert_eq!(frame(*needs), *expected, "{needs:?}");
    }
}

/// A loop as code of either length has it.
fn jumps(is_long: bool) -> Vec<u32> {
    let [a, b, ..] = General::ARGUMENTS;
    let mut assembler = Assembler::new(D);
    assembler.is_long = is_long;
    let again = assembler.label();
    let end: Forward = assembler.skip_if_zero(a);
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
    // ldr s0, .+64; ldr d0, .+64; ldr q0, .+64 twice
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
    // adrp x16, two pages on; ldr d0, [x16, #16]
    for (form, near) in [(D, 0xfd40_0a00), (S, 0xbd40_1200), (D2, 0x3dc0_0600)] {
        let mut assembler = Assembler::new(form);
        let instructions = 50_000;
        assembler.open(&Needs { stack: 0, uses_pointers: false, vectors: 0, instructions });
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

/// The bits of this register are those of a thread on some systems.
#[test]
fn no_register_of_a_system_is_named() {
    let all = General::ARGUMENTS.into_iter().chain(General::SPARE).chain(General::POINTERS);
    let mut numbers: Vec<u32> = all.map(General::number).collect();
    numbers.sort_unstable();
    numbers.dedup();
    assert_eq!(numbers.len(), 5 + 3 + 13, "each has one use");
    assert!(numbers.iter().all(|number| ![16, 17, 18, 25, 26, 27, 28, 29, 30, 31].contains(number)));
}
