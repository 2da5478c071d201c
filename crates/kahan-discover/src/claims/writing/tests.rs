//! Tests the form of written formulas, and that they read back as equal formulas.

use super::*;
use kahan_algebra::lexer;

fn polynomials(expression: &str) -> (Symbols, [Polynomial; 2]) {
    let text = format!("xdot = a*y*z; ydot = x; zdot = x^2; integral H = {expression};");
    let tokens = lexer::lex(&text).tokens;
    let system = kahan_algebra::read_unproved(&tokens).system().expect("a system");
    let function = crate::tests::function(&system.claims[0]);
    (system.field.symbols.clone(), [function.numerator().clone(), function.denominator().clone()])
}

fn written(expression: &str, by: &str) -> String {
    let (symbols, [above, below]) = polynomials(expression);
    let text = quotient(&symbols, &[above], &[below], &[polynomials(by).1[0].clone()]);
    assert_eq!(polynomials(&text).1, polynomials(expression).1, "{text}");
    text
}

#[test]
fn sums_stand_in_factors_their_first_terms_positive() {
    let cases = [
        ("x^2 - y^2", "(x + y)*(x - y)"),
        ("-(x - y)^3/(2*eps^2*x)", "-(x - y)^3/(2*eps^2*x)"),
        ("(2*x + 4*y)/(6 - 6*z)", "(x + 2*y)/(3*(1 - z))"),
        ("(x + y)/z^2", "(x + y)/z^2"),
        ("1/(eps^2*x^2 - 1)", "-1/((1 + eps*x)*(1 - eps*x))"),
        ("(x + y)*(x + 2*y)/(x^2 + y^2)^2", "(x + 2*y)*(x + y)/(x^2 + y^2)^2"),
        ("-3", "-3"),
        ("x*y", "x*y"),
    ];
    for (expression, expected) in cases {
        assert_eq!(written(expression, "x"), expected);
    }
}

#[test]
fn long_factors_are_written_by_powers_of_known_ones() {
    let (base, known) = ("a*x + y^2", "1 - eps^2*a*x - eps^2*y^2");
    let digits = format!("(y - z)^2*({base})^3 + a*(1 + z*y)*({base}) - eps^2*(y + z^3)^2");
    let text = written(&format!("({digits})/z"), known);
    assert!(text.contains(&format!("({base})^3")) && text.len() < digits.len() + 12, "{text}");
    let plain = written(&format!("({digits})/z"), "z");
    assert!(text.len() < plain.len(), "{plain}");
}

#[test]
fn sums_are_grouped_where_that_is_shorter() {
    let cases = [
        ("1 - 4*eps^2*x^2 - 4*eps^2*y^2", "1 - 4*eps^2*(x^2 + y^2)"),
        ("1 + eps^2*x^2 + eps^2*y", "1 + eps^2*(y + x^2)"),
        ("a^2*x*y + x*y + a^2*z^2 + z^2 + x^2", "x^2 + (x*y + z^2)*(1 + a^2)"),
        ("1 - eps^2*(a^2 - 2)*(1 + x + y*z)^2", "1 + eps^2*(2 - a^2)*(1 + x + y*z)^2"),
        ("(1 + eps*(x + y + z))*(1 - eps*(x + y + z))", "1 - eps^2*(x + y + z)^2"),
        ("(1 + eps*(x + y + z))^2*(1 - eps*(x + y + z))", ""),
        ("x^2 + y^2 + eps^2", "x^2 + y^2 + eps^2"),
    ];
    for (expression, expected) in cases {
        let text = written(expression, "x");
        assert!(text == expected || expected.is_empty(), "{text}");
    }
}
