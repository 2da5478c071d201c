//! Tests how wide formulas are broken into lines, boxes and matrices.

use super::{boxed, display, equation, lines, matrix, width_of};

#[test]
fn widths_are_about_what_the_eye_sees() {
    for (formula, width) in [
        ("x", 1),
        ("\\varepsilon x_{12}^{2}", 5),
        ("a + b", 5),
        ("-a", 2),
        ("\\frac{a + b}{c}", 5),
        ("\\left(a + b\\right)^{2}", 8),
        ("\\mathit{al}", 2),
        ("\\begin{aligned} & a + b \\\\ & c \\end{aligned} d", 6),
        ("\\{x,y\\}", 5),
    ] {
        assert_eq!(width_of(formula), width, "{formula}");
    }
}

#[test]
fn sums_break_before_a_sign_and_products_between_factors() {
    assert_eq!(lines("a + b - c + d", 8), ["a + b", "- c + d"]);
    assert_eq!(lines("aaaa bbbb cccc", 9), ["aaaa bbbb", "\\cdot cccc"]);
    assert_eq!(lines("\\dot {x} y", 1), ["\\dot {x}", "\\cdot y"]);
    assert_eq!(lines("a + b", 5), ["a + b"]);
}

#[test]
fn fractions_and_parentheses_break_inside() {
    let sum = ["aaaaaaaa"; 4].join(" + ");
    let two = "\\begin{aligned}\n& aaaaaaaa + aaaaaaaa \\\\\n& + aaaaaaaa + aaaaaaaa\n\\end{aligned}";
    assert_eq!(boxed(&sum, 24), two);
    assert_eq!(
        lines(&format!("x + 2\\varepsilon\\,\\frac{{{sum}}}{{b}}"), 26),
        ["x".to_owned(), format!("+ 2\\varepsilon\\,\\frac{{{two}}}{{b}}")]
    );
    assert_eq!(
        lines(&format!("b \\left({sum}\\right)^{{2}}"), 23),
        ["b".to_owned(), format!("\\cdot \\left({two}\\right)^{{2}}")]
    );
}

#[test]
fn statements_break_at_their_relation() {
    let sum = ["aaaaaaaa"; 4].join(" + ");
    assert_eq!(display("a = b", 10), "a = b");
    assert_eq!(
        display(&format!("f = {sum}"), 25),
        "\\begin{aligned}\nf &= aaaaaaaa + aaaaaaaa \\\\\n&\\quad + aaaaaaaa + aaaaaaaa\n\\end{aligned}"
    );
    assert_eq!(
        display(&format!("{sum} \\neq 0"), 28),
        "\\begin{aligned}\n& aaaaaaaa + aaaaaaaa \\\\\n&\\quad + aaaaaaaa + aaaaaaaa \\\\\n&\\quad \\neq 0\n\\end{aligned}"
    );
    assert!(width_of(&display(&sum, 25)) <= 25);
}

#[test]
fn equations_and_matrices_stay_within_the_width() {
    let sum = ["aaaaaaaa"; 6].join(" - ");
    let equation = equation("\\dot{x}", &sum, 40);
    assert_eq!(equation.matches("\\\\\n&\\quad - ").count(), 1, "{equation}");
    let rows = vec![vec!["1".to_owned(), sum.clone()], vec![sum, "0".to_owned()]];
    let matrix = matrix("pmatrix", &rows, 60);
    assert!(width_of(&matrix) <= 60, "{matrix}");
    assert_eq!(matrix.matches("\\begin{aligned}").count(), 2);
}
