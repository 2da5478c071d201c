//! Compares each lane of a lane type with one float, operation by operation.

use std::eprintln;
use std::fmt::Debug;

use crate::ensemble::Level;
use crate::ensemble::columns::{GROUP, Group};
use crate::ensemble::lanes::Lanes;
use crate::{Constant, Scalar};

/// The number of operations that are compared. The last three are multiply-adds.
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

/// Computes all operations on one float.
macro_rules! operations_on {
    ($name:ident, $float:ty) => {
        pub(in crate::ensemble) fn $name(
            a: $float,
            b: $float,
            c: $float,
            fused: bool,
        ) -> [$float; OPERATIONS] {
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

/// Yields floats from random bits, with all exponents. Every fourth float is a special value.
macro_rules! operands_of {
    ($name:ident, $float:ty, $bits:ty) => {
        pub(in crate::ensemble) fn $name(seed: u64) -> impl Iterator<Item = $float> {
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

fn random_bits(seed: u64) -> impl Iterator<Item = u64> {
    (1_u64..).map(move |k| {
        let z = seed.wrapping_add(k.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    })
}

pub(in crate::ensemble) fn left_out(level: Level) -> bool {
    if !level.is_available() {
        eprintln!("left out: this processor lacks {level:?}");
    }
    !level.is_available()
}

pub(in crate::ensemble) fn compare<L, T>(
    operands: &[Group<T>; 3],
    expected: impl Fn(T, T, T) -> [T; OPERATIONS],
) where
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
                // Debug text tells −0 from 0, and is equal for all NaNs.
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
pub(in crate::ensemble) use every_lane_computes_as_one_float;

pub(in crate::ensemble) fn numbers_fill_all_lanes_of<L: Lanes<T>, T: Scalar + Copy>() {
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
