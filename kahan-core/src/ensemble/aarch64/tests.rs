//! Compares each lane of each lane type with one float, operation by operation.

use crate::ensemble::Level;
use crate::ensemble::registers::tests::{
    compare, every_lane_computes_as_one_float, left_out, numbers_fill_all_lanes_of, operands_f32,
    operands_f64, operations_f32, operations_f64,
};

use super::lanes::{F32x4, F32x4Fused, F64x2, F64x2Fused};

every_lane_computes_as_one_float!(baseline, Level::Baseline, false, F32x4, F64x2);
every_lane_computes_as_one_float!(neon, Level::Neon, true, F32x4Fused, F64x2Fused);

#[test]
fn numbers_fill_all_lanes() {
    numbers_fill_all_lanes_of::<F64x2, f64>();
    numbers_fill_all_lanes_of::<F32x4, f32>();
    numbers_fill_all_lanes_of::<F64x2Fused, f64>();
    numbers_fill_all_lanes_of::<F32x4Fused, f32>();
}
