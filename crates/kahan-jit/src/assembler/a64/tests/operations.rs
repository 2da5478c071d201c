//! Encodings of floating-point instructions.

use super::{Binary, D, D2, Fused, FusedOrder, S, S4, check, r, v};

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
        // mov v17.16b, v9.16b (numbers in single precision are only copied)
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
        (S, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D132, v(9), v(1), r(23)), &[0x1f09_0631]),
        // fmadd s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D132, v(9), v(9), r(9)), &[0x1f11_4631]),
        // fmadd s17, s1, s17, s9
        (S, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D213, v(9), v(1), r(23)), &[0x1f11_2431]),
        // fmadd s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D213, v(9), v(9), r(9)), &[0x1f11_4631]),
        // fmadd s17, s1, s9, s17
        (S, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D231, v(9), v(1), r(23)), &[0x1f09_4431]),
        // fmadd s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D231, v(9), v(9), r(9)), &[0x1f11_4631]),
        // fnmsub s17, s17, s9, s1
        (S, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D132, v(9), v(1), r(23)), &[0x1f29_8631]),
        // fnmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D132, v(9), v(9), r(9)), &[0x1f31_c631]),
        // fnmsub s17, s1, s17, s9
        (S, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D213, v(9), v(1), r(23)), &[0x1f31_a431]),
        // fnmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D213, v(9), v(9), r(9)), &[0x1f31_c631]),
        // fnmsub s17, s1, s9, s17
        (S, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D231, v(9), v(1), r(23)), &[0x1f29_c431]),
        // fnmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D231, v(9), v(9), r(9)), &[0x1f31_c631]),
        // fmsub s17, s17, s9, s1
        (S, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D132, v(9), v(1), r(23)), &[0x1f09_8631]),
        // fmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D132, v(9), v(9), r(9)), &[0x1f11_c631]),
        // fmsub s17, s1, s17, s9
        (S, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D213, v(9), v(1), r(23)), &[0x1f11_a431]),
        // fmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D213, v(9), v(9), r(9)), &[0x1f11_c631]),
        // fmsub s17, s1, s9, s17
        (S, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D231, v(9), v(1), r(23)), &[0x1f09_c431]),
        // fmsub s17, s17, s17, s17
        (S, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D231, v(9), v(9), r(9)), &[0x1f11_c631]),
        // fmadd d17, d17, d9, d1
        (D, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D132, v(9), v(1), r(23)), &[0x1f49_0631]),
        // fmadd d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D132, v(9), v(9), r(9)), &[0x1f51_4631]),
        // fmadd d17, d1, d17, d9
        (D, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D213, v(9), v(1), r(23)), &[0x1f51_2431]),
        // fmadd d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D213, v(9), v(9), r(9)), &[0x1f51_4631]),
        // fmadd d17, d1, d9, d17
        (D, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D231, v(9), v(1), r(23)), &[0x1f49_4431]),
        // fmadd d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D231, v(9), v(9), r(9)), &[0x1f51_4631]),
        // fnmsub d17, d17, d9, d1
        (D, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D132, v(9), v(1), r(23)), &[0x1f69_8631]),
        // fnmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D132, v(9), v(9), r(9)), &[0x1f71_c631]),
        // fnmsub d17, d1, d17, d9
        (D, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D213, v(9), v(1), r(23)), &[0x1f71_a431]),
        // fnmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D213, v(9), v(9), r(9)), &[0x1f71_c631]),
        // fnmsub d17, d1, d9, d17
        (D, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D231, v(9), v(1), r(23)), &[0x1f69_c431]),
        // fnmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D231, v(9), v(9), r(9)), &[0x1f71_c631]),
        // fmsub d17, d17, d9, d1
        (D, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D132, v(9), v(1), r(23)), &[0x1f49_8631]),
        // fmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D132, v(9), v(9), r(9)), &[0x1f51_c631]),
        // fmsub d17, d1, d17, d9
        (D, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D213, v(9), v(1), r(23)), &[0x1f51_a431]),
        // fmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D213, v(9), v(9), r(9)), &[0x1f51_c631]),
        // fmsub d17, d1, d9, d17
        (D, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D231, v(9), v(1), r(23)), &[0x1f49_c431]),
        // fmsub d17, d17, d17, d17
        (D, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D231, v(9), v(9), r(9)), &[0x1f51_c631]),
        // mov v30.16b, v1.16b; fmla v30.4s, v17.4s, v9.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D132, v(9), v(1), r(23)),
            &[0x4ea1_1c3e, 0x4e29_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D132, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v9.16b; fmla v30.4s, v1.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D213, v(9), v(1), r(23)),
            &[0x4ea9_1d3e, 0x4e31_cc3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D213, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // fmla v17.4s, v1.4s, v9.4s
        (S4, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D231, v(9), v(1), r(23)), &[0x4e29_cc31]),
        // mov v30.16b, v17.16b; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D231, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // fneg v30.4s, v1.4s; fmla v30.4s, v17.4s, v9.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D132, v(9), v(1), r(23)),
            &[0x6ea0_f83e, 0x4e29_ce3e, 0x4ebe_1fd1]),
        // fneg v30.4s, v17.4s; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D132, v(9), v(9), r(9)),
            &[0x6ea0_fa3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // fneg v30.4s, v9.4s; fmla v30.4s, v1.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D213, v(9), v(1), r(23)),
            &[0x6ea0_f93e, 0x4e31_cc3e, 0x4ebe_1fd1]),
        // fneg v30.4s, v17.4s; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D213, v(9), v(9), r(9)),
            &[0x6ea0_fa3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // fneg v17.4s, v17.4s; fmla v17.4s, v1.4s, v9.4s
        (S4, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D231, v(9), v(1), r(23)),
            &[0x6ea0_fa31, 0x4e29_cc31]),
        // fneg v30.4s, v17.4s; fmla v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D231, v(9), v(9), r(9)),
            &[0x6ea0_fa3e, 0x4e31_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v1.16b; fmls v30.4s, v17.4s, v9.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D132, v(9), v(1), r(23)),
            &[0x4ea1_1c3e, 0x4ea9_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmls v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D132, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4eb1_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v9.16b; fmls v30.4s, v1.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D213, v(9), v(1), r(23)),
            &[0x4ea9_1d3e, 0x4eb1_cc3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmls v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D213, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4eb1_ce3e, 0x4ebe_1fd1]),
        // fmls v17.4s, v1.4s, v9.4s
        (S4, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D231, v(9), v(1), r(23)), &[0x4ea9_cc31]),
        // mov v30.16b, v17.16b; fmls v30.4s, v17.4s, v17.4s; mov v17.16b, v30.16b
        (S4, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D231, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4eb1_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v1.16b; fmla v30.2d, v17.2d, v9.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D132, v(9), v(1), r(23)),
            &[0x4ea1_1c3e, 0x4e69_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D132, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v9.16b; fmla v30.2d, v1.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D213, v(9), v(1), r(23)),
            &[0x4ea9_1d3e, 0x4e71_cc3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D213, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // fmla v17.2d, v1.2d, v9.2d
        (D2, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D231, v(9), v(1), r(23)), &[0x4e69_cc31]),
        // mov v30.16b, v17.16b; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplyAdd, FusedOrder::D231, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // fneg v30.2d, v1.2d; fmla v30.2d, v17.2d, v9.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D132, v(9), v(1), r(23)),
            &[0x6ee0_f83e, 0x4e69_ce3e, 0x4ebe_1fd1]),
        // fneg v30.2d, v17.2d; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D132, v(9), v(9), r(9)),
            &[0x6ee0_fa3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // fneg v30.2d, v9.2d; fmla v30.2d, v1.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D213, v(9), v(1), r(23)),
            &[0x6ee0_f93e, 0x4e71_cc3e, 0x4ebe_1fd1]),
        // fneg v30.2d, v17.2d; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D213, v(9), v(9), r(9)),
            &[0x6ee0_fa3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // fneg v17.2d, v17.2d; fmla v17.2d, v1.2d, v9.2d
        (D2, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D231, v(9), v(1), r(23)),
            &[0x6ee0_fa31, 0x4e69_cc31]),
        // fneg v30.2d, v17.2d; fmla v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::MultiplySubtract, FusedOrder::D231, v(9), v(9), r(9)),
            &[0x6ee0_fa3e, 0x4e71_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v1.16b; fmls v30.2d, v17.2d, v9.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D132, v(9), v(1), r(23)),
            &[0x4ea1_1c3e, 0x4ee9_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmls v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D132, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4ef1_ce3e, 0x4ebe_1fd1]),
        // mov v30.16b, v9.16b; fmls v30.2d, v1.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D213, v(9), v(1), r(23)),
            &[0x4ea9_1d3e, 0x4ef1_cc3e, 0x4ebe_1fd1]),
        // mov v30.16b, v17.16b; fmls v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D213, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4ef1_ce3e, 0x4ebe_1fd1]),
        // fmls v17.2d, v1.2d, v9.2d
        (D2, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D231, v(9), v(1), r(23)), &[0x4ee9_cc31]),
        // mov v30.16b, v17.16b; fmls v30.2d, v17.2d, v17.2d; mov v17.16b, v30.16b
        (D2, &|x| x.fused(Fused::SubtractProduct, FusedOrder::D231, v(9), v(9), r(9)),
            &[0x4eb1_1e3e, 0x4ef1_ce3e, 0x4ebe_1fd1]),
    ]);
}
