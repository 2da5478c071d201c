use num_bigint::BigInt;
use num_rational::BigRational;

use num_traits::One;

use super::{Rational, is_canonical, rounding};

fn q(text: &str) -> Rational {
    Rational::parse(text).unwrap_or_else(|| panic!("{text} should read as a number"))
}

fn samples() -> Vec<Rational> {
    let edges =
        [0, 1, -1, 2, 3, -6, 12, 1 << 31, (1 << 31) + 1, -(1 << 53) - 1, i64::MAX, i64::MIN, i64::MIN + 1];
    let mut samples = Vec::new();
    for num in edges {
        for den in edges.iter().filter(|den| **den != 0) {
            samples.push(Rational::new(num, *den));
        }
    }
    samples.push(q("123456789012345678901234567890/7"));
    samples.push(q("-1e-40"));
    let floats = [0.1, -0.3, 1e-3, -1e-5, 7e-12, 2.5, -3e20, 5e-324];
    samples.extend(floats.iter().filter_map(|float| Rational::from_f64(*float)));
    samples
}

#[test]
fn every_operation_agrees_with_big_rationals_and_is_canonical() {
    let samples = samples();
    for a in &samples {
        assert!(is_canonical(a), "{a}");
        for b in &samples {
            for (ours, theirs) in [
                (a + b, a.to_big() + b.to_big()),
                (a - b, a.to_big() - b.to_big()),
                (a * b, a.to_big() * b.to_big()),
            ] {
                assert!(is_canonical(&ours), "{a} and {b} gave {ours}");
                assert_eq!(ours.to_big(), theirs, "{a} and {b}");
                assert_eq!(ours, Rational::from(theirs));
            }
            assert_eq!(a.cmp(b), a.to_big().cmp(&b.to_big()), "{a} and {b}");
            match a.checked_div(b) {
                Some(quotient) => {
                    assert!(is_canonical(&quotient));
                    assert_eq!(&quotient * b, *a);
                }
                None => assert!(b.is_zero()),
            }
            if !(a.is_zero() && b.is_zero()) {
                let common = a.gcd(b);
                assert!(is_canonical(&common) && !common.is_negative());
                assert!(a.checked_div(&common).unwrap().is_integer());
                assert!(b.checked_div(&common).unwrap().is_integer());
            }
        }
    }
}

#[test]
fn negation_and_powers_keep_the_normal_form() {
    for a in samples() {
        assert!(is_canonical(&-&a) && (&a + &-&a).is_zero());
        let mut product = Rational::one();
        for exponent in 0..5 {
            let power = a.pow(exponent).unwrap();
            assert!(is_canonical(&power));
            assert_eq!(power, product);
            assert_eq!(a.pow(-exponent), power.recip());
            product = &product * &a;
        }
    }
    assert_eq!(Rational::zero().pow(0), Some(Rational::one()));
    assert_eq!(Rational::zero().pow(-1), None);
}

#[test]
fn numbers_mean_what_is_written() {
    assert_eq!(q("6/4"), Rational::new(3, 2));
    assert_eq!(q("-7"), Rational::from(-7));
    assert_eq!(q("0.25"), Rational::new(1, 4));
    assert_eq!(q("1e-3"), Rational::new(1, 1000));
    assert_eq!(q("-1.5e3"), Rational::from(-1500));
    assert_eq!(q("1.5E+1"), Rational::from(15));
    assert_eq!(q("9223372036854775808").as_i64(), None);
    assert_eq!(q("-9223372036854775808").as_i64(), Some(i64::MIN));
    assert_eq!(q("1e4096").denominator(), BigInt::from(1));
    for wrong in [
        "",
        "-",
        ".",
        "1e",
        "1e4097",
        "1e-4097",
        "1e99999999999999999999",
        "1/0",
        "1/-2",
        "1 ",
        "0x1",
        "--1",
        "1e1.5",
        "e3",
        ".e3",
        "1__0",
        "_1",
        "1_",
        "1 2",
        "inf",
    ] {
        assert_eq!(Rational::parse(wrong), None, "{wrong}");
    }
}

#[test]
fn display_reads_back() {
    for a in samples() {
        assert_eq!(q(&a.to_string()), a);
        assert_eq!(format!("{a:?}"), a.to_string());
    }
    assert_eq!(Rational::new(4, -6).to_string(), "-2/3");
    assert_eq!(Rational::from(BigRational::new(BigInt::from(8), BigInt::from(-2))).to_string(), "-4");
}

#[test]
fn bits_measure_the_larger_part() {
    assert_eq!((q("0").bits(), q("-8").bits(), q("1/16").bits()), (1, 4, 5));
    assert_eq!(q("1/18446744073709551616").bits(), 65);
}

fn agrees_with_the_standard_library(text: &str) {
    let exact = q(text);
    assert_eq!(exact.to_f64().to_bits(), text.parse::<f64>().unwrap().to_bits(), "{text} as f64");
    assert_eq!(exact.to_f32().to_bits(), text.parse::<f32>().unwrap().to_bits(), "{text} as f32");
}

#[test]
fn rounding_agrees_with_the_standard_library() {
    for text in [
        "0",
        "0.1",
        "1e-3",
        "123456789.123456789",
        "9007199254740993",
        "9007199254740992.5",
        "9007199254740995",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "1.7976931348623159e308",
        "1e309",
        "1e4000",
        "1e-4000",
        "4.9e-324",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "2.2250738585072011e-308",
        "2.2250738585072014e-308",
        "3.4028235e38",
        "3.4028236e38",
        "1.4e-45",
        "7.006492321624085e-46",
        "7.006492321624086e-46",
        "1.17549435e-38",
        "1.1754942e-38",
        "16777217",
        "16777219",
        "1.00000017881393432617187499",
        "1.00000017881393432617187500",
        "1.00000017881393432617187501",
    ] {
        agrees_with_the_standard_library(text);
        assert_eq!(q(&format!("-{text}")).to_f64(), -q(text).to_f64());
    }
    let mut state = 1_u64;
    for _ in 0..2000 {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let exponent = i64::try_from(state >> 33).unwrap() % 340 - 335;
        agrees_with_the_standard_library(&format!("{}e{exponent}", state >> 12));
        agrees_with_the_standard_library(&format!("{}e{}", state >> 12, exponent / 7));
    }
}

#[test]
fn halfway_cases_go_to_even_and_the_slightest_excess_goes_up() {
    let tiny = Rational::new(1, 2).pow(3000).unwrap();
    let mut state = 7_u64;
    let mut finite = 0;
    for _ in 0..300 {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let low = f64::from_bits(state >> 1 & !(1 << 62) | (state & (1 << 61)) << 1);
        let high = f64::from_bits(low.to_bits() + 1);
        let (Some(a), Some(b)) = (Rational::from_f64(low), Rational::from_f64(high)) else { continue };
        let middle = &(&a + &b) * &Rational::new(1, 2);
        let even = if low.to_bits().is_multiple_of(2) { low } else { high };
        assert_eq!(middle.to_f64(), even);
        assert_eq!((&middle + &(&tiny * &a)).to_f64(), high);
        assert_eq!((&middle - &(&tiny * &a)).to_f64(), low);
        assert_eq!(a.to_f64(), low);
        finite += 1;
    }
    assert!(finite > 290, "{finite} floats");
}

#[test]
fn a_double_double_leaves_less_than_half_an_ulp_of_its_tail() {
    for text in ["1/3", "0.1", "-22/7", "123456789012345678901234567890/7", "1e-300", "9223372036854775807"] {
        let exact = q(text);
        let (hi, lo) = exact.to_double_double();
        assert_eq!(hi + lo, hi);
        let rest = &(&exact - &Rational::from_f64(hi).unwrap()) - &Rational::from_f64(lo).unwrap();
        let half_ulp = (&exact.abs() * &Rational::new(1, 2).pow(106).unwrap()).abs();
        assert!(rest.abs() <= half_ulp || lo.abs() < f64::MIN_POSITIVE, "{text} leaves {rest}");
    }
    assert_eq!(q("3/4").to_double_double(), (0.75, 0.0));
    assert_eq!(q("1e400").to_double_double(), (f64::INFINITY, 0.0));
}

#[test]
fn numbers_are_read_as_people_type_them() {
    for (typed, meant) in [
        (".1", "1/10"),
        ("-.25", "-1/4"),
        ("5.", "5"),
        ("5.e3", "5000"),
        ("+3/7", "3/7"),
        (".1/.3", "1/3"),
        ("1_000.5", "2001/2"),
        ("1.5E3", "1500"),
        (".5e-1", "1/20"),
    ] {
        assert_eq!(q(typed).to_string(), meant, "{typed}");
    }
}

#[test]
fn dyadic_numbers_are_floats_exactly_and_round_as_all_others() {
    let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
    for _ in 0..20_000 {
        bits = bits.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        let value = f64::from_bits(bits ^ (bits >> 29));
        let Some(exact) = Rational::from_f64(value) else {
            assert!(!value.is_finite());
            continue;
        };
        assert_eq!(exact, Rational::from(BigRational::from_float(value).unwrap()), "{value}");
        assert_eq!(exact.to_f64().to_bits(), value.to_bits() & if value == 0.0 { 0 } else { u64::MAX });
        for odd in [bits | 1, bits >> 5 | 1, bits >> 9 | 1] {
            for shift in [0_u32, 3, 40, 63, 64, 200, 1022, 1023, 1070, 1140] {
                let exact = Rational::from(BigRational::new(odd.into(), BigInt::one() << shift));
                let divided = f64::from_bits(rounding::round_bits(&exact.magnitude(), rounding::BINARY64));
                assert_eq!(exact.to_f64(), divided, "{odd}/2^{shift}");
                let single =
                    f32::from_bits(rounding::round_bits(&exact.magnitude(), rounding::BINARY32) as u32);
                assert_eq!(exact.to_f32(), single, "{odd}/2^{shift}");
            }
        }
    }
}
