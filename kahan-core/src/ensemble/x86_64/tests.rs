//! Each lane of each type against one float, operation by operation, and the estimated reciprocal
//! against division.
//!
//! What the processor lacks is left out, and the test says so.

use std::eprintln;
use std::fmt::Debug;

use crate::ensemble::Level;
use crate::ensemble::columns::{GROUP, Group};
use crate::ensemble::lanes::Lanes;
use crate::{Constant, Scalar};

use super::estimated::{F32x16Estimated, F64x8Estimated};
use super::lanes::{F32x4, F32x8, F32x16, F64x2, F64x4, F64x8};

/// The operations of a scalar, the last three of them fused where multiply-adds are.
const OPERATIONS: usize = 14;

fn operations<L: Lanes<T>, T>(a: L, b: L, c: L) -> [L; OPERATIONS] {
    let mut assigned = [a; 4];
    assigned[0] += b;
    assigned[1] -= b;
    assigned[2] *= b;
    assigned[3] /= b;
    let [sum, difference, product, quotient] = assigned;
    [
        a + b,
        a - b,
        a * b,
        a / b,
        sum,
        difference,
        product,
        quotient,
        -a,
        a.reciprocal().expect("floats have reciprocals"),
        a.quotient(b).expect("floats have quotients"),
        a.multiply_add(b, c),
        a.multiply_subtract(b, c),
        c.subtract_product(a, b),
    ]
}

/// The same on one float, with one rounding or two in the multiply-adds.
macro_rules! operations_on {
    ($name:ident, $float:ty) => {
        fn $name(a: $float, b: $float, c: $float, fused: bool) -> [$float; OPERATIONS] {
            let mut results = operations::<$float, $float>(a, b, c);
            let multiply_adds = if fused {
                [a.mul_add(b, c), a.mul_add(b, -c), (-a).mul_add(b, c)]
            } else {
                [a * b + c, a * b - c, c - a * b]
            };
            results[OPERATIONS - 3..].copy_from_slice(&multiply_adds);
            results
        }
    };
}
operations_on!(operations_f32, f32);
operations_on!(operations_f64, f64);

/// Floats as bits, so that every exponent comes up and no two runs differ; every fourth one is a
/// special case.
macro_rules! operands_of {
    ($name:ident, $float:ty, $bits:ty) => {
        fn $name(seed: u64) -> impl Iterator<Item = $float> {
            let special = [0.0, -0.0, 1.0, 1e-40, <$float>::MAX, <$float>::INFINITY, <$float>::NAN];
            random_bits(seed).enumerate().map(move |(k, bits)| {
                let float = <$float>::from_bits((bits >> (64 - <$bits>::BITS)) as $bits);
                if k % 4 == 0 { special[bits as usize % special.len()] } else { float }
            })
        }
    };
}
operands_of!(operands_f32, f32, u32);
operands_of!(operands_f64, f64, u64);

/// The sequence SplitMix64.
fn random_bits(seed: u64) -> impl Iterator<Item = u64> {
    (1_u64..).map(move |k| {
        let z = seed.wrapping_add(k.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    })
}

fn left_out(level: Level) -> bool {
    if !level.is_available() {
        eprintln!("left out: this processor lacks {level:?}");
    }
    !level.is_available()
}

/// Three groups of operands through lanes and through floats.
fn compare<L, T>(operands: &[Group<T>; 3], expected: impl Fn(T, T, T) -> [T; OPERATIONS])
where
    L: Lanes<T>,
    T: Copy + PartialEq + Debug,
{
    for place in (0..GROUP).step_by(L::WIDTH) {
        let [a, b, c] = operands.each_ref().map(|group| L::load(group, place));
        for (operation, lanes) in operations(a, b, c).into_iter().enumerate() {
            let mut results = operands[0];
            lanes.store(&mut results, place);
            for k in place..place + L::WIDTH {
                let [a, b, c] = operands.map(|group| group[k]);
                let one = expected(a, b, c)[operation];
                let (text, text_of_one) = (std::format!("{:?}", results[k]), std::format!("{one:?}"));
                // The text tells −0 from 0, and one not-a-number from a number but not from
                // another.
                assert_eq!(text, text_of_one, "operation {operation} on {a:?}, {b:?}, {c:?}");
            }
        }
    }
}

macro_rules! every_lane_computes_as_one_float {
    ($name:ident, $level:expr, $fused:expr, $lanes_f32:ty, $lanes_f64:ty) => {
        #[test]
        fn $name() {
            if left_out($level) {
                return;
            }
            let rounds = if cfg!(miri) { 1 } else { 200 };
            let (mut singles, mut doubles) = (operands_f32(1), operands_f64(2));
            for _ in 0..rounds {
                let operands = [(); 3].map(|()| core::array::from_fn(|_| singles.next().expect("endless")));
                compare::<$lanes_f32, f32>(&operands, |a, b, c| operations_f32(a, b, c, $fused));
                let operands = [(); 3].map(|()| core::array::from_fn(|_| doubles.next().expect("endless")));
                compare::<$lanes_f64, f64>(&operands, |a, b, c| operations_f64(a, b, c, $fused));
            }
        }
    };
}
every_lane_computes_as_one_float!(sse2, Level::Baseline, cfg!(target_feature = "fma"), F32x4, F64x2);
every_lane_computes_as_one_float!(avx2, Level::Avx2, true, F32x8, F64x4);
every_lane_computes_as_one_float!(avx512, Level::Avx512, true, F32x16, F64x8);

#[test]
fn numbers_fill_all_lanes() {
    fn check<L: Lanes<T>, T: Scalar + Copy>() {
        let third = Constant::ratio(1, 3);
        for (lanes, one) in
            [(L::constant(&third), T::constant(&third)), (L::zero(), T::zero()), (L::one(), T::one())]
        {
            let mut group = [T::constant(&Constant::integer(7)); GROUP];
            lanes.store(&mut group, 0);
            assert!(group[..L::WIDTH].iter().all(|entry| *entry == one));
            assert!(group[L::WIDTH..].iter().all(|entry| *entry == T::constant(&Constant::integer(7))));
            assert_eq!(lanes.is_zero(), one.is_zero());
            assert!(lanes == L::load(&[one; GROUP], 0) && lanes != L::constant(&Constant::integer(7)));
        }
    }
    check::<F64x2, f64>();
    check::<F32x4, f32>();
    if !left_out(Level::Avx2) {
        check::<F64x4, f64>();
        check::<F32x8, f32>();
    }
    if !left_out(Level::Avx512) {
        check::<F64x8, f64>();
        check::<F32x16, f32>();
    }
}

macro_rules! estimates_are_near_quotients {
    ($name:ident, $lanes:ty, $float:ty, $operands:ident, $share:literal) => {
        /// Over numbers of every exponent whose reciprocal is finite, subnormal ones included.
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
            // None at all would be a division.
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
