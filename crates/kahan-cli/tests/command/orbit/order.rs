//! Tests `kahan orbit --order` against the library's compositions, bit for bit.

use kahan_core::Composition;
use kahan_core::prelude::*;
use kahan_systems::{E6, EulerTop};
use serde_json::Value;

use super::kahan;

fn object(arguments: &[&str]) -> Value {
    let output = kahan(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {output:?}");
    serde_json::from_slice(&output.stdout).expect("one object")
}

fn rows(arguments: &[&str]) -> Vec<Vec<f64>> {
    let output = kahan(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {output:?}");
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let row = |line: &str| line.split(',').skip(2).map(|cell| cell.parse().expect("a float")).collect();
    text.lines().skip(1).map(row).collect()
}

/// Generated code rounds differently on targets with fused multiply-adds.
#[cfg_attr(target_feature = "fma", ignore = "this target fuses multiply-adds")]
#[test]
fn orbits_of_every_order_are_those_of_the_library_bit_for_bit() {
    let top = EulerTop { a1: 0.5, a2: -0.7, a3: 1.25 };
    for order in ["2", "4", "6", "8"] {
        let composition = Composition::of_order(order.parse().expect("an order")).expect("a composition");
        let common = ["--eps", "0.05", "--steps", "100", "--order", order];
        let e6 = [&["e6", "--at", "1,2,3"], &common[..]].concat();
        assert_eq!(object(&[&e6[..], &["--json"]].concat())["order"].to_string(), order);
        let orbit = E6.orbit(vector![1.0, 2.0, 3.0], 0.05).composed(composition);
        for (row, x) in rows(&e6).iter().zip(orbit.take(101)) {
            let integrals = E6.integrals(&x, if order == "2" { 0.05 } else { 0.0 });
            assert_eq!(*row, [x[0], x[1], x[2], integrals[0], integrals[1]]);
        }
        let parameters = ["--param", "a1=0.5", "--param", "a2=-0.7", "--param", "a3=1.25"];
        let euler = rows(&[&["euler", "--at", "0.4,0.8,0.5"], &parameters[..], &common[..]].concat());
        assert_eq!(euler.len(), 101);
        let orbit = top.orbit(vector![0.4, 0.8, 0.5], 0.05).composed(composition);
        for (row, x) in euler.iter().zip(orbit) {
            assert_eq!(row[..3], [x[0], x[1], x[2]]);
        }
    }
}

/// Returns the largest change of an integral over 200 steps at ε = 0.05 in `f64`.
fn change(order: &str, column: usize) -> f64 {
    let rows = rows(&["e6", "--eps", "0.05", "--at", "1/2,1/4,-3/4", "--steps", "200", "--order", order]);
    rows.iter().map(|row| (row[column] - rows[0][column]).abs()).fold(0.0, f64::max)
}

/// Kahan's map preserves the integral. A composition changes it, but less if its order is higher.
#[test]
fn a_composition_keeps_the_integral_of_the_flow_to_its_order() {
    assert!(change("2", 3) < 1e-14);
    let [four, six, eight] = ["4", "6", "8"].map(|order| change(order, 3));
    assert!(
        1e-6 > four && four > 50.0 * six && six > 50.0 * eight && eight > 1e-14,
        "{four}, {six}, {eight}"
    );
}

#[test]
fn a_field_of_one_s_own_is_composed_with_single_precision_too() {
    let field = ["--field", "xdot = y; ydot = 6*x^2 - a;", "--param", "a=2"];
    let more = ["--eps", "1e-2", "--at", "0,1", "--steps", "10", "--order", "8", "--scalar"];
    let single = rows(&[&field[..], &more[..], &["f32"]].concat());
    let double = rows(&[&field[..], &more[..], &["f64"]].concat());
    for (single, double) in single.iter().zip(&double) {
        // The bound allows a few rounding errors of `f32` (6e-8) in 17 stages of each of ten steps.
        assert!(single.iter().zip(double).all(|(a, b)| (a - b).abs() < 1e-4), "{single:?} {double:?}");
    }
    assert!(single != double);
}

#[test]
fn exact_numbers_are_refused_with_the_reason() {
    let output =
        kahan(&["e6", "--eps", "1/20", "--at", "1,2,3", "--steps", "5", "--order", "8", "--scalar", "exact"]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).expect("UTF-8");
    assert!(message.contains("irrational") && message.contains("--scalar f64"), "{message}");
}
