//! Compares numbers as text with exact rationals.

use std::format;
use std::string::ToString;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};

use super::dyadic::Dyadic;
use super::operands::Operands;
use crate::Dd;

fn rational(text: &str) -> BigRational {
    let (significand, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, fraction) = significand.split_once('.').unwrap_or((significand, ""));
    let digits: BigInt = [whole, fraction].concat().parse().unwrap();
    let exponent = exponent.parse::<i32>().unwrap() - fraction.len() as i32;
    BigRational::from_integer(digits) * BigRational::from_integer(10.into()).pow(exponent)
}

#[test]
fn every_digit_is_correct() {
    let mut operands = Operands::seeded(11);
    for i in 0..600 {
        let exponent = if i % 2 == 0 { operands.between(-1022, 1022) } else { operands.between(-20, 20) };
        let x = operands.number(exponent);
        let exact = Dyadic::of(x).to_rational();
        for text in [x.to_string(), format!("{x:e}")] {
            let written = rational(&text);
            let digits = format!("{x:.31e}");
            // The tolerance is half a unit of the 32nd digit.
            let unit = BigRational::from_integer(10.into())
                .pow(digits.split_once('e').unwrap().1.parse::<i32>().unwrap() - 31);
            assert!((&written - &exact).abs() * BigRational::from_integer(2.into()) <= unit, "{text}");
            assert_eq!(written, rational(&digits));
        }
        let long = format!("{x:.1100e}");
        assert_eq!(rational(&long), exact, "{long}");
        assert_eq!(long.parse(), Ok(x), "every digit reads back");
    }
}

#[test]
fn each_part_is_the_float_nearest_to_what_is_left() {
    let mut operands = Operands::seeded(12);
    for i in 0..1500 {
        let digits = operands.between(1, 60);
        let mut text = if operands.below(2) == 0 { "-".to_string() } else { "0".to_string() };
        for _ in 0..digits {
            text.push(char::from(b'0' + operands.below(10) as u8));
        }
        text.push('.');
        for _ in 0..operands.between(1, 50) {
            text.push(char::from(b'0' + operands.below(10) as u8));
        }
        let exponent = if i % 3 == 0 { operands.between(-330, 200) } else { operands.between(-50, 20) };
        let text = format!("{text}e{exponent}");
        let exact = rational(&text);
        let read: Dd = text.parse().unwrap();
        assert_eq!(read.high(), exact.to_f64().unwrap(), "{text}");
        let left = exact - Dyadic::float(read.high()).to_rational();
        let low = if left.is_zero() { 0.0 } else { left.to_f64().unwrap() };
        assert_eq!(read.low(), low, "{text}");
    }
}
