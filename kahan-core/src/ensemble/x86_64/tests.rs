//! Compares each lane of the lane types that divide with a float, and the estimated reciprocal with
//! division.

use crate::ensemble::Level;
use crate::ensemble::columns::{GROUP, Group};
use crate::ensemble::lanes::Lanes;
use crate::ensemble::registers::tests::{
    compare, every_lane_computes_as_one_float, left_out, numbers_fill_all_lanes_of, operands_f32,
    operands_f64, operations_f32, operations_f64,
};

use super::estimated::{F32x16Estimated, F64x8Estimated};
use super::lanes::{F32x4, F32x8, F32x16, F64x2, F64x4, F64x8};

every_lane_computes_as_one_float!(sse2, Level::Baseline, cfg!(target_feature = "fma"), F32x4, F64x2);
every_lane_computes_as_one_float!(avx2, Level::Avx2, true, F32x8, F64x4);
every_lane_computes_as_one_float!(avx512, Level::Avx512, true, F32x16, F64x8);

#[test]
fn numbers_fill_all_lanes() {
    numbers_fill_all_lanes_of::<F64x2, f64>();
    numbers_fill_all_lanes_of::<F32x4, f32>();
    if !left_out(Level::Avx2) {
        numbers_fill_all_lanes_of::<F64x4, f64>();
        numbers_fill_all_lanes_of::<F32x8, f32>();
    }
    if !left_out(Level::Avx512) {
        numbers_fill_all_lanes_of::<F64x8, f64>();
        numbers_fill_all_lanes_of::<F32x16, f32>();
    }
}

macro_rules! estimates_are_near_quotients {
    ($name:ident, $lanes:ty, $float:ty, $operands:ident, $share:literal) => {
        /// The operands are random, and have all exponents for which 1/x is finite.
        #[test]
        #[cfg_attr(miri, ignore = "Miri knows no estimate")]
        fn $name() {
            if left_out(Level::Avx512) {
                return;
            }
            let groups = 1 << 16;
            let mut operands = $operands(3).filter(|x| *x != 0.0 && x.is_finite() && (1.0 / x).is_finite());
            let mut off = 0;
            for _ in 0..groups {
                let x: Group<$float> = core::array::from_fn(|_| operands.next().expect("endless"));
                for (x, reciprocal) in x.into_iter().zip(reciprocals::<$lanes, $float>(x)) {
                    let distance = reciprocal.to_bits().abs_diff((1.0 / x).to_bits());
                    assert!(distance <= 1, "1/{x:e} estimated as {reciprocal:e}");
                    off += u32::from(distance == 1);
                }
            }
            let share = f64::from(off) / (groups * GROUP) as f64;
            assert!(share < $share, "{off} of {} are not rounded correctly", groups * GROUP);
            assert!(off > 0);
        }
    };
}
estimates_are_near_quotients!(estimates_f64, F64x8Estimated, f64, operands_f64, 0.0015);
estimates_are_near_quotients!(estimates_f32, F32x16Estimated, f32, operands_f32, 0.004);

#[test]
#[cfg_attr(miri, ignore = "Miri knows no estimate")]
fn what_has_no_finite_reciprocal_is_estimated_as_no_number() {
    if left_out(Level::Avx512) {
        return;
    }
    for x in [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, 1e-309] {
        assert!(reciprocals::<F64x8Estimated, f64>([x; GROUP]).iter().all(|entry| entry.is_nan()));
    }
    for x in [0.0, -0.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, 1e-39] {
        assert!(reciprocals::<F32x16Estimated, f32>([x; GROUP]).iter().all(|entry| entry.is_nan()));
    }
}

fn reciprocals<L: Lanes<T>, T>(mut group: Group<T>) -> Group<T> {
    for place in (0..GROUP).step_by(L::WIDTH) {
        let reciprocal = L::load(&group, place).reciprocal().expect("floats have reciprocals");
        reciprocal.store(&mut group, place);
    }
    group
}
