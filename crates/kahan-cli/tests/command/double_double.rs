//! Tests `--scalar dd`: digits, bits, exact inputs, poles and overflow.

use std::process::Output;

use kahan_core::num_rational::BigRational;
use kahan_core::prelude::*;
use kahan_core::{Composition, num_traits::Signed};
use kahan_systems::{E6, E7, LotkaVolterra};
use serde_json::{Number, Value};

use crate::running::{self, text};

fn kahan(arguments: &str) -> Output {
    running::kahan(&arguments.split(' ').collect::<Vec<_>>())
}

fn answer(arguments: &str) -> String {
    let output = kahan(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments}: {}", text(&output.stderr));
    text(&output.stdout)
}

fn object(arguments: &str) -> Value {
    serde_json::from_str(&answer(arguments)).expect("JSON")
}

fn points(csv: &str, dimension: usize) -> Vec<Vec<String>> {
    let row = |line: &str| line.split(',').skip(2).take(dimension).map(str::to_owned).collect();
    csv.lines().skip(1).map(row).collect()
}

fn written(number: Dd) -> String {
    let text = number.to_string();
    if text.contains(['.', 'e']) { text } else { text + ".0" }
}

fn library<const N: usize>(orbit: impl Iterator<Item = SVector<Dd, N>>, steps: usize) -> Vec<Vec<String>> {
    orbit.take(steps + 1).map(|point| point.iter().copied().map(written).collect()).collect()
}

fn dd(text: &str) -> Dd {
    text.parse().expect("a number")
}

#[test]
fn steps_are_those_of_the_compiled_library_to_the_last_digit() {
    let csv = answer("orbit e6 --eps 0.05 --at 1,0.3,-2 --steps 40 --scalar dd");
    let start = vector![dd("1"), dd("0.3"), dd("-2")];
    assert_eq!(points(&csv, 3), library(E6.orbit(start, dd("0.05")), 40));

    let csv = answer("orbit e7 --eps -1/8 --at 0.1,0.2,0.3 --param xi=1.1 --steps 20 --scalar dd");
    let start = vector![dd("0.1"), dd("0.2"), dd("0.3")];
    assert_eq!(points(&csv, 3), library(E7 { xi: dd("1.1") }.orbit(start, dd("-0.125")), 20));

    let csv = answer("orbit lv --eps 0.1 --at 0.5,1.7 --steps 20 --order 8 --scalar dd");
    let orbit = LotkaVolterra.orbit(vector![dd("0.5"), dd("1.7")], dd("0.1"));
    assert_eq!(points(&csv, 2), library(orbit.composed(Composition::KAHAN_LI_8), 20));
}

fn rational(text: &str) -> BigRational {
    let (significand, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, fraction) = significand.split_once('.').unwrap_or((significand, ""));
    let digits: BigRational = [whole, fraction].concat().parse().expect("digits");
    let ten: BigRational = "10".parse().expect("ten");
    digits * ten.pow(exponent.parse::<i32>().expect("an exponent") - fraction.len() as i32)
}

/// Inputs such as 0.1 are rounded to 32 digits.
#[test]
fn every_object_has_the_exact_value_to_30_digits() {
    let arguments = "eval e6 --eps 0.1 --at 1/3,2/7,0.7 --json";
    let (exact, rounded) = (object(arguments), object(&[arguments, " --scalar dd"].concat()));
    let mut compared = 0;
    for key in
        ["eps", "x", "field", "A", "b", "det_A", "x_next", "jacobian", "det_jacobian", "integrals", "density"]
    {
        compare(&exact[key], &rounded[key], &mut compared);
    }
    assert!(compared > 35, "{compared}");
}

fn compare(exact: &Value, rounded: &Value, compared: &mut usize) {
    match (exact, rounded) {
        (Value::String(exact), Value::Number(rounded)) => {
            let exact: BigRational = exact.parse().expect("p/q");
            let error = (rational(rounded.as_str()) - &exact).abs();
            assert!(error <= exact.abs() * rational("1e-30"), "{rounded}, not {exact}");
            *compared += 1;
        }
        (Value::Array(exact), Value::Array(rounded)) => {
            assert_eq!(exact.len(), rounded.len());
            exact.iter().zip(rounded).for_each(|(exact, rounded)| compare(exact, rounded, compared));
        }
        (Value::Object(exact), Value::Object(rounded)) => {
            for (key, value) in exact {
                compare(value, &rounded[key], compared);
            }
        }
        _ => panic!("{exact} against {rounded}"),
    }
}

#[test]
fn a_number_in_json_has_32_digits() {
    let evaluated = object("eval e1 --eps 1/3 --at 1/7,1/3,2 --scalar dd --json");
    assert_eq!(
        evaluated["eps"],
        Value::Number("0.33333333333333333333333333333333".parse::<Number>().unwrap())
    );
    assert_eq!(evaluated["x"][2].to_string(), "2.0");
    let orbit = object("orbit e1 --eps 1/3 --at 1/7,1/3,2 --steps 1 --scalar dd --json");
    assert_eq!(orbit["scalar"], "dd");
    assert_eq!(orbit["rows"][0][2].to_string(), "0.14285714285714285714285714285714");
    assert_eq!(orbit["rows"][1][0].to_string(), "1");
    assert_eq!(orbit["steps"], 1);
    let floats = object("eval e1 --eps 1/3 --at 1/7,1/3,2 --scalar f64 --json");
    assert_eq!(floats["eps"].to_string(), (1.0 / 3.0).to_string());
}

#[test]
fn a_pole_and_an_overflow_are_reported() {
    let output = kahan("orbit e1 --eps 1/2 --at -1,1,0 --steps 3 --scalar dd");
    assert_eq!(output.status.code(), Some(1));
    let why = text(&output.stderr);
    assert!(why.contains("pole") && why.contains("n = 0"), "{why}");
    assert_eq!(points(&text(&output.stdout), 3).len(), 1);

    let output = kahan("eval e1 --eps 1/2 --at -1,1,0 --scalar dd");
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("det A = 0"));

    let output = kahan("orbit e1 --eps 1e400 --at -1,1,0 --steps 3 --scalar dd");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("beyond the range of dd"), "{}", text(&output.stderr));
}
