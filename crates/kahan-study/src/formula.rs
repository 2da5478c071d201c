//! Formulas in floats: of the index of a site, `1 + 1/2*cos(2*pi*i/n)`, or of the variables of a
//! state.
//!
//! In: text in the language of `kahan!`, with functions and any exponents. Out: a value at each
//! site or state. The module must not know how the text is read, only what its names and functions
//! mean.

use std::f64::consts::PI;
use std::fmt;

use kahan_algebra::diagnostics::{Diagnostic, Kind};
use kahan_algebra::lexer::lex;
use kahan_algebra::parse::{parse_formula, parse_formulas};
use kahan_algebra::render::report;
use kahan_algebra::syntax::{Expr, ExprKind, InFormula};
use kahan_algebra::token::{Span, Token};

/// A function of one number.
pub type Function = fn(f64) -> f64;

/// What can be called, by name.
const FUNCTIONS: [(&str, Function); 15] = [
    ("sin", f64::sin),
    ("cos", f64::cos),
    ("tan", f64::tan),
    ("asin", f64::asin),
    ("acos", f64::acos),
    ("atan", f64::atan),
    ("sinh", f64::sinh),
    ("cosh", f64::cosh),
    ("tanh", f64::tanh),
    ("sech", |x| x.cosh().recip()),
    ("exp", f64::exp),
    ("log", f64::ln),
    ("sqrt", f64::sqrt),
    ("abs", f64::abs),
    ("floor", f64::floor),
];

/// A formula, read.
#[derive(Clone, Debug)]
pub enum Formula {
    /// A number.
    Number(f64),
    /// The variable with this index.
    Variable(usize),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Formula)>),
    /// Factors, each with whether it divides.
    Product(Vec<(bool, Formula)>),
    /// What is after a minus sign.
    Negation(Box<Formula>),
    /// A base and its exponent.
    Power(Box<[Formula; 2]>),
    /// A function of a number.
    Call(Function, Box<Formula>),
}

impl Formula {
    /// The value at a site, whose index is the only variable.
    #[must_use]
    pub fn at(&self, site: usize) -> f64 {
        self.of(&[site as f64])
    }

    /// The value at these variables.
    #[must_use]
    pub fn of(&self, variables: &[f64]) -> f64 {
        match self {
            Self::Number(value) => *value,
            Self::Variable(k) => variables[*k],
            // Of the two zeros, −0 changes no sum.
            Self::Sum(terms) => terms.iter().fold(-0.0, |sum, (is_subtracted, term)| {
                let term = term.of(variables);
                if *is_subtracted { sum - term } else { sum + term }
            }),
            Self::Product(factors) => factors.iter().fold(1.0, |product, (divides, factor)| {
                let factor = factor.of(variables);
                if *divides { product / factor } else { product * factor }
            }),
            Self::Negation(of) => -of.of(variables),
            Self::Power(parts) => {
                let [base, exponent] = [parts[0].of(variables), parts[1].of(variables)];
                if exponent.fract() == 0.0 && exponent.abs() <= 1024.0 {
                    base.powi(exponent as i32)
                } else {
                    base.powf(exponent)
                }
            }
            Self::Call(function, of) => function(of.of(variables)),
        }
    }

    /// The last of the variables that it names; `None` where it is one number everywhere.
    #[must_use]
    pub fn last_variable(&self) -> Option<usize> {
        match self {
            Self::Number(_) => None,
            Self::Variable(k) => Some(*k),
            Self::Sum(parts) | Self::Product(parts) => {
                parts.iter().filter_map(|(_, part)| part.last_variable()).max()
            }
            Self::Negation(of) | Self::Call(_, of) => of.last_variable(),
            Self::Power(parts) => parts.iter().filter_map(Self::last_variable).max(),
        }
    }
}

/// Names that stand for numbers, beside `pi`.
pub type Known = [(String, f64)];

/// The names of a formula of sites.
const OF_SITES: [&str; 1] = ["i"];

/// Why a text is no formula.
#[derive(Clone, Debug)]
pub struct NoFormula {
    text: String,
    mistake: Diagnostic,
}

impl NoFormula {
    /// The mistake with the line that it stands in and a caret; `origin` is what the text is
    /// called.
    #[must_use]
    pub fn report(&self, origin: &str) -> String {
        report(&self.mistake, &self.text, &lex(&self.text).ranges, origin)
    }
}

impl fmt::Display for NoFormula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.report("formula"))
    }
}

impl std::error::Error for NoFormula {}

/// One formula of the index of a site.
///
/// # Errors
/// The first mistake.
pub fn formula(text: &str, known: &Known) -> Result<Formula, NoFormula> {
    formula_of(&OF_SITES, text, known)
}

/// One formula of these variables.
///
/// # Errors
/// The first mistake.
pub fn formula_of(variables: &[&str], text: &str, known: &Known) -> Result<Formula, NoFormula> {
    read(text, |tokens| Names { variables, known }.lower(&parse_formula(tokens)?))
}

/// Formulas of the index of a site by name: `a = 1; b = i/n`.
///
/// # Errors
/// The first mistake.
pub fn formulas(text: &str, known: &Known) -> Result<Vec<(String, Formula)>, NoFormula> {
    read(text, |tokens| {
        let names = Names { variables: &OF_SITES, known };
        let formulas = parse_formulas(tokens)?.into_iter();
        formulas.map(|(name, formula)| Ok((name.text, names.lower(&formula)?))).collect()
    })
}

fn read<R>(text: &str, read: impl FnOnce(&[Token]) -> Result<R, Diagnostic>) -> Result<R, NoFormula> {
    read(&lex(text).tokens).map_err(|mistake| NoFormula { text: text.to_owned(), mistake })
}

/// What the names in a formula mean.
struct Names<'a> {
    variables: &'a [&'a str],
    known: &'a Known,
}

impl Names<'_> {
    fn lower(&self, expr: &Expr<InFormula>) -> Result<Formula, Diagnostic> {
        let lower = |expr: &Expr<InFormula>| self.lower(expr);
        Ok(match &expr.kind {
            ExprKind::Number(value) => Formula::Number(value.to_f64()),
            ExprKind::Name(name) => self.named(name, expr.span)?,
            ExprKind::Sum(terms) => {
                let terms = terms.iter().map(|term| Ok((term.negative, lower(&term.expr)?)));
                Formula::Sum(terms.collect::<Result<_, Diagnostic>>()?)
            }
            ExprKind::Product(factors) => {
                let factors = factors.iter().map(|factor| Ok((factor.divides, lower(&factor.expr)?)));
                Formula::Product(factors.collect::<Result<_, Diagnostic>>()?)
            }
            ExprKind::Negation(inner) => Formula::Negation(Box::new(lower(inner)?)),
            ExprKind::Power(base, exponent) => {
                Formula::Power(Box::new([lower(base)?, Formula::Number(*exponent as f64)]))
            }
            ExprKind::Special(InFormula::Power(parts)) => {
                Formula::Power(Box::new([lower(&parts[0])?, lower(&parts[1])?]))
            }
            ExprKind::Special(InFormula::Call { function, arguments }) => {
                let (function, argument) = self.call(function, arguments, expr.span)?;
                Formula::Call(function, Box::new(lower(argument)?))
            }
        })
    }

    /// The value or the variable of this name.
    fn named(&self, name: &str, span: Span) -> Result<Formula, Diagnostic> {
        let variable = self.variables.iter().position(|variable| *variable == name);
        let known = self.known.iter().find(|(known, _)| known == name);
        match (variable, known) {
            (Some(variable), _) => Ok(Formula::Variable(variable)),
            (None, Some((_, value))) => Ok(Formula::Number(*value)),
            (None, None) if name == "pi" => Ok(Formula::Number(PI)),
            (None, None) if FUNCTIONS.iter().any(|(function, _)| *function == name) => Err(mistake(
                span,
                format!("`{name}` is a function, and its argument is missing"),
                format!("write the argument in parentheses: `{name}(i)`"),
            )),
            (None, None) => {
                let known = self.known.iter().map(|(name, _)| name.as_str());
                let names: Vec<&str> = self.variables.iter().copied().chain(known).collect();
                let help = format!("there are {}, pi, and the functions {}", names.join(", "), functions());
                Err(mistake(span, format!("`{name}` is not known here"), help))
            }
        }
    }

    /// What is called, with its argument.
    fn call<'a>(
        &self,
        name: &str,
        arguments: &'a [Expr<InFormula>],
        span: Span,
    ) -> Result<(Function, &'a Expr<InFormula>), Diagnostic> {
        let Some((_, function)) = FUNCTIONS.iter().find(|(known, _)| *known == name) else {
            let help = match self.named(name, span) {
                Ok(_) => format!("for a product write `{name}*(…)`"),
                Err(_) => format!("there are {}", functions()),
            };
            return Err(mistake(span, format!("`{name}(…)` calls no function that is known here"), help));
        };
        match arguments {
            [argument] => Ok((*function, argument)),
            _ => {
                let message = format!("`{name}` is a function of one number, not of {}", arguments.len());
                Err(mistake(span, message, format!("write `{name}(…)` without a comma")))
            }
        }
    }
}

/// The mistake of a name that means something else here, or nothing.
fn mistake(span: Span, message: String, help: String) -> Diagnostic {
    Diagnostic::new(Kind::UnknownName, span, message, help)
}

/// The functions by name, in a row.
fn functions() -> String {
    FUNCTIONS.map(|(name, _)| name).join(", ")
}

#[cfg(test)]
mod tests {
    use super::{formula, formulas};

    #[test]
    fn formulas_bind_as_the_language_does() {
        let known = [("n".to_owned(), 8.0), ("h".to_owned(), 0.5)];
        for (text, at_three) in [
            ("1 + 2*i", 7.0),
            ("-i^2", -9.0),
            ("(-i)^2", 9.0),
            ("2^-1", 0.5),
            ("i/n/2 - 1 - 1", -1.8125),
            ("--i", 3.0),
            ("2*-h", -1.0),
            ("cos(2*pi*i/n)^2 + sin(2*pi*i/n)^2", 1.0),
            ("sech(0) + sqrt(4) - exp(0)*abs(-2)", 1.0),
            ("4^0.5 + 1e-1", 2.1),
            ("9^(i - 2.5)", 3.0),
        ] {
            let value = formula(text, &known).expect(text).at(3);
            assert!((value - at_three).abs() < 1e-15, "{text}: {value}");
        }
        assert_eq!(formula("i*0", &[]).expect("a formula").last_variable(), Some(0));
        assert_eq!(formula("sin(1)^2", &[]).expect("a formula").last_variable(), None);
        let named = formulas("x = i; y = 2;", &known).expect("two");
        assert_eq!(
            named.iter().map(|(name, formula)| (name.as_str(), formula.at(5))).collect::<Vec<_>>(),
            [("x", 5.0), ("y", 2.0)]
        );
    }

    #[test]
    fn values_are_rounded_as_written() {
        for (text, value) in [
            ("1/10 + 0.2 - 0.3", 0.1 + 0.2 - 0.3),
            ("0.1 - (0.2 - i)", 0.1 - (0.2 - 3.0)),
            ("i/10*7/3", 3.0 / 10.0 * 7.0 / 3.0),
            ("-0 + -0", -0.0),
            ("-0*i", -0.0),
            ("i^-2*2^0.3", 3_f64.powi(-2) * 2_f64.powf(0.3)),
            ("1.1^i", 1.1_f64.powi(3)),
            ("1.1^1025", 1.1_f64.powf(1025.0)),
        ] {
            let found = formula(text, &[]).expect(text).at(3);
            assert_eq!(found.to_bits(), value.to_bits(), "{text}: {found}, not {value}");
        }
    }

    #[test]
    fn long_formulas_are_read() {
        let long = vec!["i*1"; 20_000].join(" + ");
        assert_eq!(formula(&long, &[]).expect("a sum").at(2), 40_000.0);
    }

    #[test]
    fn mistakes_are_shown_where_they_stand() {
        let deep = "(".repeat(10_000);
        let signs = "-".repeat(10_000);
        for (text, part) in [
            ("", "missing"),
            ("1 +", "missing"),
            ("2 i", "`2*i` for a product"),
            ("2i", "a product needs its `*`"),
            ("m + 1", "`m` is not known"),
            ("sin 1", "`sin(i)` for a function"),
            ("1 + sin", "in parentheses: `sin(i)`"),
            ("sine(1)", "`sine(…)` calls no function"),
            ("i(1 + i)", "for a product write `i*(…)`"),
            ("sin(i, 1)", "a function of one number, not of 2"),
            ("(1", "this `(` is not closed"),
            ("1^2^3", "write `(a^b)^c`"),
            ("2 \\ i", "error"),
            (&deep, "nests deeper"),
            (&signs, "nests deeper"),
        ] {
            let refusal = formula(text, &[]).expect_err(text).to_string();
            assert!(refusal.contains(part), "{text}: {refusal}");
        }
        for text in ["x", "= 1", "x = 1 y = 2", "3 = x"] {
            assert!(formulas(text, &[]).is_err(), "{text}");
        }
    }
}
