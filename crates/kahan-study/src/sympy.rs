//! Formulas as `sympy.sympify` reads them.

use kahan_algebra::poly::Polynomial;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::syntax::Expr;

/// The language of Python's SymPy: `1/2*x**2`, which `sympify` reads exactly.
///
/// A name that Python keeps for itself gets a `_` behind it, and the second copy of a state, `x'`,
/// is `x_prime`. SymPy has values of its own for names such as `E` or `S`: whoever reads a formula
/// hands its symbols over, `sympify(formula, locals={"E": Symbol("E")})`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SymPy;

/// The words that Python keeps for itself.
const KEYWORDS: [&str; 35] = [
    "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class", "continue", "def",
    "del", "elif", "else", "except", "finally", "for", "from", "global", "if", "import", "in", "is",
    "lambda", "nonlocal", "not", "or", "pass", "raise", "return", "try", "while", "with", "yield",
];

/// A formula of [`Text`] in the words of Python.
fn python(text: &str) -> String {
    let mut formula = String::new();
    for part in text.split_inclusive(|c: char| !c.is_alphanumeric() && c != '_') {
        let name = part.trim_end_matches(|c: char| !c.is_alphanumeric() && c != '_');
        formula += name;
        formula += if KEYWORDS.contains(&name) { "_" } else { "" };
        formula += match &part[name.len()..] {
            "^" => "**",
            "'" => "_prime",
            "~" => "_next",
            other => other,
        };
    }
    formula
}

impl Notation for SymPy {
    fn name(&self, name: &str) -> String {
        python(name)
    }

    fn image(&self, name: &str) -> String {
        python(&Text.image(name))
    }

    fn entry(&self, row: &str, column: &str) -> String {
        python(&Text.entry(row, column))
    }

    fn number(&self, value: &Rational) -> String {
        Text.number(value)
    }

    fn power(&self, base: &str, exponent: i64) -> String {
        python(&Text.power(base, exponent))
    }

    fn product(&self, factors: &[String]) -> String {
        Text.product(factors)
    }

    fn quotient(&self, above: &str, below: &str) -> String {
        Text.quotient(above, below)
    }

    fn moved(&self, symbols: &Symbols, name: &str, above: &Polynomial, below: &Polynomial) -> String {
        python(&Text.moved(symbols, name, above, below))
    }

    fn expression(&self, expr: &Expr) -> String {
        python(&Text.expression(expr))
    }
}
