//! Tests that products, divisors and differences are kept as written unless they cancel.

use kahan_algebra::arithmetic::{Arithmetic, Exact, Float64};
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::lexer::lex;
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_algebra::{derive, read};

fn system(text: &str) -> System {
    read(&lex(text).tokens).system().unwrap_or_else(|mistakes| panic!("{text}: {mistakes:?}"))
}

/// Returns f at a state and parameters in order of first use. Returns `None` at a division by zero.
fn field<A: Arithmetic<Constant = Rational>>(
    text: &str,
    arithmetic: &A,
    state: &[A::Value],
    parameters: &[A::Value],
) -> Option<Vec<A::Value>> {
    let eps = arithmetic.constant(&Rational::new(1, 8))?;
    let point = Point { state: state.to_vec(), parameters: parameters.to_vec(), eps };
    Interpreter::new(&system(text)).evaluate(arithmetic, &point).ok().map(|found| found.field)
}

fn q(value: i64) -> Rational {
    Rational::from(value)
}

#[test]
fn a_difference_and_a_divisor_are_computed_as_they_are_written() {
    let (p, r) = (1.0 + 1e-9, 0.5);
    let f = field("xdot = (p - q)*x/(1 + r) + x/(p - q); ydot = y;", &Float64, &[3.0, 1.0], &[p, 1.0, r]);
    assert_eq!(f.expect("defined")[0], (1.0 / (1.0 + r)) * (3.0 * (p - 1.0)) + (1.0 / (p - 1.0)) * 3.0);
    let f = field("xdot = (x - a)*(y - b); ydot = x;", &Float64, &[p, 1.0 + 3e-9], &[1.0, 1.0]);
    assert_eq!(f.expect("defined")[0], (p - 1.0) * ((1.0 + 3e-9) - 1.0));
}

#[test]
fn differences_in_parentheses_and_the_order_of_a_factor_are_kept() {
    let [p, x, small] = [1.0 + 1e-9, 2.0 + 1e-9, 1e-9_f64];
    let f = field("xdot = y + (x - z) + (p - q); ydot = 0; zdot = 0;", &Float64, &[x, small, 2.0], &[p, 1.0]);
    assert_eq!(f.expect("defined")[0], small + (x - 2.0) + (p - 1.0));
    let f = field(
        "xdot = x*(1 - p - q); ydot = (z - x + y)*x; zdot = 0;",
        &Float64,
        &[x, small, 2.0],
        &[p, small],
    );
    assert_eq!(f.expect("defined")[..2], [x * ((1.0 - p) - small), x * ((2.0 - x) + small)]);
}

#[test]
fn what_cancels_leaves_no_pole() {
    for (text, value) in [
        ("xdot = (p^2 - q^2)*x/(p - q); ydot = y;", q(20)),
        ("xdot = x*p/(p - q) - x*q/(p - q); ydot = y;", q(2)),
        ("xdot = (p - q)*x/(p - q) + q*y; ydot = y;", q(17)),
        ("xdot = x/(1/(p - q)) + q*y; ydot = y + p/(1 + q);", q(15)),
    ] {
        let f = field(text, &Exact, &[q(2), q(3)], &[q(5), q(5)]);
        assert_eq!(f.expect("p = q is no pole")[0], value, "{text}");
    }
    let text = "xdot = (p^2 - q^2)*x/(p - q) + x/(q - r); ydot = y;";
    assert!(field(text, &Exact, &[q(2), q(3)], &[q(5), q(5), q(1)]).is_some());
    assert!(field(text, &Exact, &[q(2), q(3)], &[q(5), q(7), q(7)]).is_none());
}

#[test]
fn a_degree_that_cancels_is_not_computed() {
    let f = field("xdot = x^2*y - x*y*x + x*y; ydot = (x*y + 1)*x - y*x^2;", &Float64, &[1e200, 1e-150], &[]);
    let f = f.expect("a polynomial");
    assert!((f[0] / 1e50 - 1.0).abs() < 1e-15 && f[1] == 1e200, "{f:?}");
}

#[test]
fn what_does_not_move_stays() {
    let f = field("xdot = (x - y)*z - x*z + y*z; ydot = 0; zdot = 1;", &Float64, &[0.1, 0.7, 0.3], &[]);
    assert_eq!(f.expect("a polynomial")[0], 0.0);
}

#[test]
fn a_relation_between_values_costs_no_reduction() {
    let text =
        |first: &str, second: &str| format!("xdot = -{first}*x*z; ydot = -{second}*y*z; zdot = x^2 + y^2;");
    let (same, related) = ("(p - q)*(p + q)", "(p^2 - q^2)");
    for (first, second) in [(same, same), (same, related), (related, related)] {
        let system = system(&text(first, second));
        assert!(derive(&system).reduced_map.is_some(), "{first} and {second}");
        let point =
            Point { state: vec![q(1), q(2), q(-1)], parameters: vec![q(3), q(1)], eps: Rational::new(1, 8) };
        let next = Interpreter::new(&system).next(&Exact, &point);
        assert!(next.is_some(), "{first} and {second}");
    }
}
