//! Tests the conversion of numbers to text and of text to numbers.

use std::format;
use std::string::{String, ToString};

use num_traits::One;

use crate::Dd;

fn read(text: &str) -> Dd {
    text.parse().unwrap()
}

#[test]
fn thirty_two_digits_unless_asked_otherwise() {
    let third = Dd::one() / Dd::from(3.0);
    assert_eq!(third.to_string(), "0.33333333333333333333333333333333");
    assert_eq!((-third).to_string(), "-0.33333333333333333333333333333333");
    assert_eq!(format!("{third:?}"), third.to_string());
    assert_eq!(format!("{third:e}"), "3.3333333333333333333333333333333e-1");
    assert_eq!(format!("{third:.3}"), "0.333");
    assert_eq!(format!("{third:.3e}"), "3.333e-1");
    assert_eq!(format!("{:.0}", Dd::from(2.5)), "2");
    assert_eq!(format!("{:.0}", Dd::new(2.5, 1e-20)), "3");
    assert_eq!(format!("{:.0}", Dd::from(0.5)), "0");
    assert_eq!(format!("{:.0}", Dd::new(0.5, 1e-20)), "1");
    assert_eq!(format!("{:.2}", Dd::from(0.001)), "0.00");
    assert_eq!(format!("{:.1}", Dd::from(99.95)), "100.0");
    assert_eq!(format!("{:.1}", Dd::from(9.75)), "9.8");
}

#[test]
fn short_numbers_are_short() {
    let cases = [
        (0.0, "0", "0e0"),
        (-0.0, "-0", "-0e0"),
        (1.0, "1", "1e0"),
        (-12.5, "-12.5", "-1.25e1"),
        (1e22, "10000000000000000000000", "1e22"),
        (9.5367431640625e-7, "9.5367431640625e-7", "9.5367431640625e-7"),
        (0.0001220703125, "0.0001220703125", "1.220703125e-4"),
        (f64::INFINITY, "inf", "inf"),
        (f64::NEG_INFINITY, "-inf", "-inf"),
        (f64::NAN, "NaN", "NaN"),
    ];
    for (x, display, exponent) in cases {
        assert_eq!(Dd::from(x).to_string(), display);
        assert_eq!(format!("{:e}", Dd::from(x)), exponent);
    }
    assert_eq!(Dd::from(5e-324).to_string(), "4.9406564584124654417656879286822e-324");
    assert_eq!(Dd::from(f64::MAX).to_string(), "1.797693134862315708145274237317e308");
    // The float 1e32 exceeds 10³² by 5366162204393472, which the low part can correct.
    assert_eq!(Dd::from(1e32).to_string(), "1.0000000000000000536616220439347e32");
    assert_eq!(Dd::new(1e32, -5_366_162_204_393_472.0).to_string(), "1e32");
    assert_eq!(Dd::new(1e31, -5e15).to_string(), "9999999999999994635896294965248");
}

#[test]
fn widths_signs_and_fills_are_those_of_floats() {
    for x in [1.5, -1.5, 0.0, f64::INFINITY, f64::NAN] {
        let y = Dd::from(x);
        assert_eq!(format!("{y:8.1}|{y:<8.1}|{y:^9.1}"), format!("{x:8.1}|{x:<8.1}|{x:^9.1}"));
        assert_eq!(format!("{y:+08.1}|{y:*>+8.1}"), format!("{x:+08.1}|{x:*>+8.1}"));
        assert_eq!(format!("{y:12.2e}|{y:+012.2e}"), format!("{x:12.2e}|{x:+012.2e}"));
    }
}

#[test]
fn without_a_low_part_the_text_is_that_of_the_float() {
    for x in [1.0 / 3.0, 123456.789, 1e-7, 2.5e10, -0.1, 5e-324, 1e300, f64::MAX, f64::MIN_POSITIVE] {
        for places in [0, 1, 2, 17, 40, 400, 1100] {
            let y = Dd::from(x);
            assert_eq!(format!("{y:.places$}"), format!("{x:.places$}"));
            assert_eq!(format!("{y:.places$e}"), format!("{x:.places$e}"));
        }
    }
}

#[test]
fn text_is_read_to_the_last_bit_of_both_parts() {
    let tenth = read("0.1");
    assert_eq!(tenth, Dd::one() / Dd::from(10.0));
    for text in ["1e-1", ".1", "+0.1", "100E-3", "0.0001e3", "0.10000000000000000000000000000000000000000000"]
    {
        assert_eq!(read(text), tenth, "{text}");
    }
    assert_eq!(read("-0.1"), -tenth);
    let pi = read("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899");
    assert_eq!((pi.high(), pi.low()), (core::f64::consts::PI, 1.2246467991473532e-16));
    assert_eq!(read("123456789012345678901234567890").to_string(), "123456789012345678901234567890");
    assert_eq!(read("1e400"), Dd::from(f64::INFINITY));
    assert_eq!(read("-1e-400").high(), -0.0);
    assert_eq!(read("-inf"), Dd::from(f64::NEG_INFINITY));
    assert!(read("nan").is_nan());
}

/// For the high part, 1 + 2⁻⁵³ is a tie, but 1 + 2⁻⁵³ ± 10⁻¹⁵⁰⁰ is not.
#[test]
fn digits_far_behind_decide_ties() {
    let half = f64::EPSILON / 2.0;
    let tie = format!("{:.53}", 1.0 + f64::EPSILON);
    assert_eq!(read(&tie), Dd::from(1.0 + f64::EPSILON));
    let middle = format!("{:.60}", Dd::new(1.0, half));
    let middle = middle.trim_end_matches('0');
    assert_eq!(read(middle), Dd::new(1.0, half));
    let above = read(&[middle, &"0".repeat(1500), "1"].concat());
    assert_eq!((above.high(), above.low()), (1.0 + f64::EPSILON, -half));

    // The number 1 + 2⁻⁶⁰ + 2⁻¹¹³ is a tie for the low part.
    let parts = [Dd::new(1.0, f64::EPSILON / 256.0), Dd::from(f64::EPSILON / 2_f64.powi(61))];
    let digits = |x: Dd| format!("{x:.150}");
    let (whole, tail) = (digits(parts[0]), digits(parts[1]));
    let sum: String = add_digits(&whole, &tail);
    assert_eq!(read(&sum), parts[0]);
    let above = read(&[&sum, "0".repeat(1500).as_str(), "1"].concat());
    assert_eq!(above.low(), parts[0].low() * (1.0 + f64::EPSILON));
}

/// Adds two positive decimals that have equally many digits after the point.
fn add_digits(a: &str, b: &str) -> String {
    let mut carry = 0;
    let mut sum: std::vec::Vec<u8> = a
        .bytes()
        .rev()
        .zip(b.bytes().rev())
        .map(|(x, y)| {
            if x == b'.' {
                return x;
            }
            let digit = x - b'0' + y - b'0' + carry;
            carry = digit / 10;
            b'0' + digit % 10
        })
        .collect();
    sum.reverse();
    String::from_utf8(sum).unwrap()
}

#[test]
fn what_floats_do_not_read_is_an_error() {
    for text in ["", "-", "1e", "0x1", "1 2", "one", "1.2.3", "--1", "e5", "1_000"] {
        let why = text.parse::<Dd>().unwrap_err();
        assert_eq!(Err(why), text.parse::<f64>());
    }
}
