//! Writes formulas in the notation of `sympy.sympify`, and a Python script that defines them.

use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{MatrixText, Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::syntax::Expr;

use crate::question::{ClaimShown, FormulaSheet};

/// The notation of Python's SymPy, `1/2*x**2`, which `sympify` reads exactly.
///
/// Python keywords get a final `_`. SymPy predefines names such as `E`, so readers must pass their
/// symbols: `sympify(formula, locals={"E": Symbol("E")})`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SymPy;

/// Names with a meaning in Python or `sympify`, which cannot be names of symbols.
const KEYWORDS: [&str; 37] = [
    "Integer", "Symbol", "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class",
    "continue", "def", "del", "elif", "else", "except", "finally", "for", "from", "global", "if", "import",
    "in", "is", "lambda", "nonlocal", "not", "or", "pass", "raise", "return", "try", "while", "with",
    "yield",
];

fn python(text: &str) -> String {
    let mut formula = String::new();
    for part in text.split_inclusive(|c: char| !c.is_alphanumeric() && c != '_') {
        let name = part.trim_end_matches(|c: char| !c.is_alphanumeric() && c != '_');
        formula += name;
        // `lambda` becomes `lambda_`, so a name `lambda_` must become `lambda__`.
        formula += if KEYWORDS.contains(&name.trim_end_matches('_')) { "_" } else { "" };
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

    fn variable(&self, symbols: &Symbols, variable: Variable) -> String {
        python(&Text.variable(symbols, variable))
    }

    fn power(&self, base: &str, exponent: i64) -> String {
        Text.power(base, exponent).replace('^', "**")
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

/// Writes the script of [`FormulaSheet::script`]. Names beyond ASCII are not passed to `sympify`,
/// since Python would normalise `ϕ` to `φ`.
pub(crate) fn script(sheet: &FormulaSheet) -> String {
    let symbols = |names: &[String]| {
        let names: Vec<String> = names.iter().map(|name| SymPy.name(name)).collect();
        format!("[Symbol(name) for name in {}]", list(&names))
    };
    let column = |entries: &[String]| matrix(entries.chunks(1));
    let square = |rows: &MatrixText| matrix(rows.iter().map(Vec::as_slice));
    let none = || "None  # It is beyond the budget of terms.".to_owned();
    let jacobian = sheet.jacobian.as_ref().map(|rows| format!("\njacobian = {}", square(rows)));
    format!(
        r#"# {system}{title}
# The map solves A*map = b; eps is half the time step.
from sympy import Matrix, Symbol, sympify

variables = {variables}
parameters = {parameters}
eps = Symbol("eps")
names = {{symbol.name: symbol for symbol in [*variables, *parameters, eps] if symbol.name.isascii()}}

field = {field}
field_jacobian = {field_jacobian}
A = {a}
b = {b}
det_A = {determinant}
map = {map}{jacobian}
claims = {{}}
{claims}"#,
        system = sheet.system,
        title = sheet.title.map(|title| format!(": {title}")).unwrap_or_default(),
        variables = symbols(&sheet.variables),
        parameters = symbols(&sheet.parameters),
        field = column(&sheet.field),
        field_jacobian = square(&sheet.field_jacobian),
        a = square(&sheet.matrix),
        b = column(&sheet.rhs),
        determinant = sheet.determinant.as_ref().map_or_else(none, |text| read(text, "names")),
        map = sheet.map.as_ref().map_or_else(none, |entries| column(entries)),
        jacobian = jacobian.unwrap_or_default(),
        claims = sheet.claims.iter().map(claim).collect::<String>(),
    )
}

/// Writes a Python list; the texts contain neither quotes nor backslashes.
fn list(texts: &[String]) -> String {
    let quoted: Vec<String> = texts.iter().map(|text| format!("\"{text}\"")).collect();
    format!("[{}]", quoted.join(", "))
}

fn matrix<'a>(rows: impl Iterator<Item = &'a [String]>) -> String {
    let rows: String = rows.map(|row| format!("    {},\n", list(row))).collect();
    format!("Matrix(sympify([\n{rows}], locals=names))")
}

fn read(formula: &str, names: &str) -> String {
    format!("sympify(\"{formula}\", locals={names})")
}

fn claim(claim: &ClaimShown) -> String {
    let when = if claim.condition.is_empty() { String::new() } else { format!(" when {}", claim.condition) };
    let notes = [claim.nonzero.as_str(), claim.source.unwrap_or_default()];
    let notes: String =
        notes.iter().filter(|note| !note.is_empty()).map(|note| format!("; {note}")).collect();
    let name = SymPy.name(&claim.name);
    let read = |formula: &str| read(formula, "names | claims");
    let value = match claim.equations.as_slice() {
        [(left, formula)] if *left == name => read(formula),
        entries => {
            let entries = entries.iter().map(|(place, value)| format!("    \"{place}\": {},\n", read(value)));
            format!("{{\n{}}}", entries.collect::<String>())
        }
    };
    format!("# {}{when}{notes}\nclaims[\"{name}\"] = {value}\n", claim.kind)
}
