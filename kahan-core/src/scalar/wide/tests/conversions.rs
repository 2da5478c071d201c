//! Tests conversions from floats and to the nearest float.

use std::string::ToString;

use num_bigint::{BigInt, Sign};
use num_traits::One;

use super::{Dyadic, Random, Wide};

/// Returns a random finite float of any exponent, with few or many bits.
fn any_f64(random: &mut Random) -> f64 {
    loop {
        let bits = random.bits() & if random.bits() & 1 == 0 { u64::MAX } else { u64::MAX << 50 };
        let bits = if random.bits() & 3 == 0 { bits & !(0x7fe << 52) } else { bits };
        let x = f64::from_bits(bits);
        if x.is_finite() {
            return x;
        }
    }
}

fn any_f32(random: &mut Random) -> f32 {
    loop {
        let bits = random.bits() as u32;
        let x = f32::from_bits(if random.bits() & 3 == 0 { bits & !(0xfe << 23) } else { bits });
        if x.is_finite() {
            return x;
        }
    }
}

#[test]
fn a_float_comes_back_bit_for_bit() {
    let mut random = Random(11);
    for _ in 0..20_000 {
        let (x, y) = (any_f64(&mut random), any_f32(&mut random));
        assert_eq!(Wide::from(x).to_f64(), x);
        assert_eq!(Wide::from(y).to_f32(), y);
    }
    let edges = [5e-324, f64::MIN_POSITIVE, f64::MIN_POSITIVE.next_down(), f64::MAX, 1.0, 0.0, -0.0];
    for x in edges {
        assert_eq!(Wide::from(x).to_f64(), x);
        assert_eq!(Wide::from(-x).to_f64(), -x);
    }
}

#[test]
fn a_float_is_taken_exactly() {
    let mut random = Random(12);
    for _ in 0..10_000 {
        let x = any_f64(&mut random);
        let exact = Dyadic::of(Wide::from(x)).scaled(1074);
        let scaled = &exact.integer * BigInt::from(2).pow(3000);
        let spelled = scaled_integer(x) * BigInt::from(2).pow(3000);
        let shift = exact.exponent;
        let value = if shift < 0 { scaled >> shift.unsigned_abs() } else { scaled << shift.unsigned_abs() };
        assert_eq!(value, spelled, "{x:e}");
    }
}

/// Returns x·2¹⁰⁷⁴ as an integer, computed by halving and doubling.
fn scaled_integer(x: f64) -> BigInt {
    let (mut size, mut shift) = (x.abs(), 1074_u64);
    while size >= 9_007_199_254_740_992.0 {
        size /= 2.0;
        shift += 1;
    }
    while size.fract() != 0.0 {
        size *= 2.0;
        shift -= 1;
    }
    let integer = BigInt::from(size as u64) << shift;
    if x < 0.0 { -integer } else { integer }
}

/// Asserts that `nearest` is the float nearest to `number`, ties to even.
macro_rules! assert_nearest {
    ($number:expr, $nearest:expr, $largest_exponent:expr) => {{
        let (number, nearest) = ($number, $nearest);
        let value = Dyadic::of(number);
        // Infinity stands for the next power of two above the largest float.
        let as_dyadic = |x| {
            let wide = Wide::from(x);
            let beyond = Wide::one().scaled($largest_exponent + 1);
            Dyadic::of(if wide.is_defined() {
                wide
            } else if x > 0.0 {
                beyond
            } else {
                -beyond
            })
        };
        let error = value.minus(&as_dyadic(nearest));
        for neighbour in [nearest.next_up(), nearest.next_down()] {
            if neighbour.is_nan() || neighbour == nearest {
                continue;
            }
            let other = value.minus(&as_dyadic(neighbour));
            assert!(error.is_within(&other), "{number:?} is nearer to {neighbour:e} than to {nearest:e}");
            if other.is_within(&error) {
                assert_eq!(nearest.to_bits() & 1, 0, "{number:?} ties, and {nearest:e} is odd");
            }
        }
    }};
}

#[test]
fn rounding_is_to_the_nearest_float() {
    let mut random = Random(13);
    for _ in 0..10_000 {
        let exponent = random.within(1100);
        let number = random.wide(exponent);
        assert_nearest!(number, number.to_f64(), 1023);
        let number = number.scaled(random.within(160) - exponent);
        assert_nearest!(number, number.to_f32(), 127);
    }
}

#[test]
fn ties_go_to_even() {
    let mut random = Random(14);
    let check = |x: f64| {
        let (here, above) = (Wide::from(x), Wide::from(x.next_up()));
        let half = (above - here).scaled(-1);
        let nudge = half.scaled(-2500);
        let even = if x.to_bits() & 1 == 0 { x } else { x.next_up() };
        assert_eq!((here + half).to_f64(), even);
        assert_eq!((-(here + half)).to_f64(), -even);
        assert_eq!((here + half - nudge).to_f64(), x);
        assert_eq!((here + half + nudge).to_f64(), x.next_up());
    };
    for _ in 0..10_000 {
        let x = any_f64(&mut random).abs();
        if x < f64::MAX {
            check(x);
        }
    }
    for x in [0.0, 5e-324, f64::MIN_POSITIVE.next_down(), f64::MIN_POSITIVE, 1.0, 1.0_f64.next_down()] {
        check(x);
    }
    for _ in 0..10_000 {
        let x = any_f32(&mut random).abs();
        if x < f32::MAX {
            let (here, above) = (Wide::from(x), Wide::from(x.next_up()));
            let even = if x.to_bits() & 1 == 0 { x } else { x.next_up() };
            assert_eq!((here + above).scaled(-1).to_f32(), even);
        }
    }
}

#[test]
fn beyond_the_largest_float_there_is_infinity() {
    // The tie between the largest float and the next power of two rounds to infinity.
    let tie = Wide::from(f64::MAX) + Wide::one().scaled(970);
    assert_eq!(tie.to_f64(), f64::INFINITY);
    assert_eq!((-tie).to_f64(), f64::NEG_INFINITY);
    assert_eq!((tie - Wide::one().scaled(650)).to_f64(), f64::MAX);
    let tie = Wide::from(f32::MAX) + Wide::one().scaled(103);
    assert_eq!((tie.to_f32(), (tie - Wide::one()).to_f32()), (f32::INFINITY, f32::MAX));
    assert_eq!(Wide::one().scaled(-1075).to_f64(), 0.0);
    assert_eq!((Wide::one().scaled(-1075) * Wide::from(1.5)).to_f64(), 5e-324);
    assert_eq!(Wide::one().scaled(100_000).to_double_double(), (f64::INFINITY, 0.0));
}

/// Compares integers of up to 100 digits, and their ratios, with results of the standard library.
#[test]
fn decimals_round_as_they_parse() {
    let mut random = Random(15);
    for _ in 0..5_000 {
        let limbs: [u64; 5] = core::array::from_fn(|_| random.bits());
        let count = 1 + (random.bits() % 5) as usize;
        let integer = BigInt::from_bytes_le(Sign::Plus, &limbs[..count].concat_bytes());
        let text = integer.to_string();
        let wide = Wide::from_limbs(false, &limbs[..count]);
        assert_eq!(wide.to_f64(), text.parse::<f64>().unwrap(), "{text}");
        assert_eq!(wide.to_f32(), text.parse::<f32>().unwrap(), "{text}");
    }
}

trait ConcatBytes {
    fn concat_bytes(&self) -> std::vec::Vec<u8>;
}

impl ConcatBytes for [u64] {
    fn concat_bytes(&self) -> std::vec::Vec<u8> {
        self.iter().flat_map(|limb| limb.to_le_bytes()).collect()
    }
}

#[test]
fn a_pair_of_floats_is_their_sum() {
    let mut random = Random(16);
    for _ in 0..10_000 {
        let high = any_f64(&mut random);
        let low = any_f64(&mut random);
        let (wide, exact) = (
            Wide::from_double_double(high, low),
            Dyadic::of(Wide::from(high)).plus(&Dyadic::of(Wide::from(low))),
        );
        assert!(Dyadic::of(wide).equals(&exact));
    }
}

#[test]
fn a_number_splits_into_the_nearest_pair() {
    let mut random = Random(17);
    for _ in 0..10_000 {
        let exponent = random.within(1000);
        let number = random.wide(exponent);
        let (high, low) = number.to_double_double();
        assert_eq!(high, number.to_f64());
        let rest = number - Wide::from(high);
        assert!(Dyadic::of(rest).equals(&Dyadic::of(number).minus(&Dyadic::of(Wide::from(high)))));
        assert_eq!(low, rest.to_f64());
        assert!(2.0 * low.abs() <= high.abs().next_up() - high.abs());
    }
}
