//! Formulas as straight-line programs. A formula's variables are those of a field with its
//! integrals, or the index i of a chain's site.
//!
//! A program performs the operations as written, and computes each repeated operation once. A
//! [`Formula`] runs in doubles, [`Formulas`] in doubles, single precision and fractions.

mod lanes;

use std::cell::RefCell;
use std::f64::consts::PI;
use std::fmt;

use kahan_algebra::arithmetic::{Exact, Float32, Float64};
use kahan_algebra::diagnostics::{Diagnostic, Kind};
use kahan_algebra::lexer::lex;
use kahan_algebra::parse::{parse_formula, parse_formulas};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::report;
use kahan_algebra::syntax::{Expr, ExprKind, FormulaSyntax};
use kahan_algebra::token::{Span, Token};
use kahan_program::{Calls, Function, Node, Program};

pub(crate) use lanes::FormulaGroup;

type Unary = fn(f64) -> f64;

const FUNCTIONS: [(&str, Unary); 15] = [
    ("sin", libm::sin),
    ("cos", libm::cos),
    ("tan", libm::tan),
    ("asin", libm::asin),
    ("acos", libm::acos),
    ("atan", libm::atan),
    ("sinh", libm::sinh),
    ("cosh", libm::cosh),
    ("tanh", libm::tanh),
    ("sech", |x| 1.0 / libm::cosh(x)),
    ("exp", libm::exp),
    ("log", libm::log),
    ("sqrt", f64::sqrt),
    ("abs", f64::abs),
    ("floor", f64::floor),
];

/// A function called by a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Called {
    /// A function of one number, given by its index in `FUNCTIONS`.
    Named(usize),
    /// a^b, computed by multiplications if b is an integer with |b| ≤ 1024.
    Power,
}

impl Function for Called {
    fn arguments(&self) -> usize {
        match self {
            Self::Named(_) => 1,
            Self::Power => 2,
        }
    }
}

impl Calls<Called> for Float64 {
    fn call(&self, function: &Called, a: &f64, b: &f64) -> Option<f64> {
        Some(match *function {
            Called::Named(index) => FUNCTIONS[index].1(*a),
            Called::Power if b.fract() == 0.0 && b.abs() <= 1024.0 => a.powi(*b as i32),
            Called::Power => libm::pow(*a, *b),
        })
    }
}

impl Calls<Called> for Float32 {
    fn call(&self, function: &Called, a: &f32, b: &f32) -> Option<f32> {
        Some(match *function {
            Called::Named(index) => FUNCTIONS[index].1((*a).into()) as f32,
            Called::Power if b.fract() == 0.0 && b.abs() <= 1024.0 => a.powi(*b as i32),
            Called::Power => libm::powf(*a, *b),
        })
    }
}

/// Fractions support only powers with integer exponents.
impl Calls<Called> for Exact {
    fn call(&self, function: &Called, a: &Rational, b: &Rational) -> Option<Rational> {
        match function {
            Called::Named(_) => None,
            Called::Power => a.pow(i32::try_from(b.as_i64()?).ok()?),
        }
    }
}

/// An operation of a formula. The inputs are the variables, followed by the named numbers.
type Operation = kahan_program::Operation<usize, Rational, Called>;

type Builder = kahan_program::Builder<usize, Rational, Called>;

/// A formula as a program with one output.
#[derive(Clone, Debug)]
pub struct Formula {
    program: Program<Vec<Operation>>,
    known: Vec<f64>,
    /// The variables that occur, each with the index of its value in the workspace.
    variables: Vec<(usize, usize)>,
}

impl Formula {
    /// Builds a formula whose inputs are `count` variables, followed by the numbers `values`.
    fn new(program: Program<Vec<Operation>>, count: usize, values: &NamedConstants) -> Self {
        let mut variables = Vec::new();
        for (place, operation) in program.operations.iter().enumerate() {
            if let Operation::Input(variable) = *operation
                && variable < count
            {
                variables.push((variable, place));
            }
        }
        let value = |input: &usize| Some(input.checked_sub(count).map_or(0.0, |known| values[known].1));
        let mut known = vec![0.0; program.operations.len()];
        program.load(&Float64, value, &mut known).expect("numbers have floats next to them");
        Formula { program, known, variables }
    }

    /// Returns the value at a site, for a formula whose only variable is the site's index.
    #[must_use]
    pub fn at(&self, site: usize) -> f64 {
        self.of(&[site as f64])
    }

    /// Returns the value at these values of the variables. Allocates a workspace on each call,
    /// unlike [`function`](Self::function).
    #[must_use]
    pub fn of(&self, variables: &[f64]) -> f64 {
        self.run(variables, &mut self.known.clone())
    }

    /// Converts the formula into a function of its variables that reuses one workspace.
    pub fn function(self) -> impl Fn(&[f64]) -> f64 {
        let workspace = RefCell::new(self.known.clone());
        move |variables| self.run(variables, &mut workspace.borrow_mut())
    }

    /// Returns the largest index of a variable in the formula; `None` if the formula is constant.
    #[must_use]
    pub fn last_variable(&self) -> Option<usize> {
        self.variables.iter().map(|(variable, _)| *variable).max()
    }

    fn run(&self, variables: &[f64], workspace: &mut [f64]) -> f64 {
        for (variable, place) in &self.variables {
            workspace[*place] = variables[*variable];
        }
        self.program.compute(&Float64, 0, workspace).expect("doubles have quotients by zero");
        workspace[self.program.outputs[0].0]
    }
}

/// Several formulas in the same variables, with the same results in doubles as [`Formula`].
#[derive(Clone, Debug)]
pub struct Formulas {
    program: Program<Vec<Operation>>,
}

impl Formulas {
    /// Reads formulas in the variables `names`, or returns the first mistake. Each definition gives
    /// a name to a formula, for use in the later definitions and in `texts`.
    pub fn read(names: &[&str], definitions: &[(&str, &str)], texts: &[&str]) -> Result<Self, NoFormula> {
        let mut builder = Builder::default();
        let mut defined: Vec<(&str, Node)> = Vec::new();
        for (name, text) in definitions {
            let value = Names { variables: names, known: &[], defined: &defined }.read(&mut builder, text)?;
            defined.push((name, value));
        }
        let names = Names { variables: names, known: &[], defined: &defined };
        let outputs: Result<Vec<Node>, NoFormula> =
            texts.iter().map(|text| names.read(&mut builder, text)).collect();
        Ok(Formulas { program: builder.finish(&outputs?) })
    }

    /// Returns the indices of the variables that the formulas use.
    #[must_use]
    pub fn needed(&self) -> Vec<usize> {
        self.program.inputs()
    }

    /// Returns the number of formulas.
    #[must_use]
    pub fn count(&self) -> usize {
        self.program.outputs.len()
    }

    /// Computes the formulas at points. `inputs` lists one [`needed`](Self::needed) variable at all
    /// points, then the next. `outputs` lists all formulas at one point, then at the next. In exact
    /// arithmetic, returns `None` if a formula is undefined.
    ///
    /// # Panics
    /// If `inputs` lacks values.
    pub fn compute<A: Calls<Called, Constant = Rational>>(
        &self,
        arithmetic: &A,
        inputs: &[A::Value],
        outputs: &mut [A::Value],
    ) -> Option<()> {
        let Program { operations, outputs: results } = &self.program;
        let zero = arithmetic.constant(&Rational::ZERO)?;
        let mut workspace = vec![zero.clone(); operations.len()];
        self.program.load(arithmetic, |_| Some(zero.clone()), &mut workspace)?;
        let is_input = |place: &usize| matches!(operations[*place], Operation::Input(_));
        let read: Vec<usize> = (0..operations.len()).filter(is_input).collect();
        let points = outputs.len().checked_div(self.count()).unwrap_or_default();
        for (point, outputs) in outputs.chunks_mut(self.count().max(1)).enumerate() {
            for (row, place) in read.iter().enumerate() {
                workspace[*place].clone_from(&inputs[row * points + point]);
            }
            self.program.compute(arithmetic, 0, &mut workspace)?;
            for (output, node) in outputs.iter_mut().zip(results) {
                output.clone_from(&workspace[node.0]);
            }
        }
        Some(())
    }
}

/// Named numbers that formulas may use, besides `pi`.
pub type NamedConstants = [(String, f64)];

const OF_SITES: [&str; 1] = ["i"];

/// The reason why a text is not a formula.
#[derive(Clone, Debug)]
pub struct NoFormula {
    text: String,
    mistake: Diagnostic,
}

impl NoFormula {
    /// Renders the mistake with its line and a caret; `origin` names the text.
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

/// Reads one formula of the index `i` of a site, or returns the first mistake.
pub fn formula(text: &str, known: &NamedConstants) -> Result<Formula, NoFormula> {
    formula_of(&OF_SITES, text, known)
}

/// Reads one formula of these variables, or returns the first mistake.
pub fn formula_of(variables: &[&str], text: &str, known: &NamedConstants) -> Result<Formula, NoFormula> {
    read(text, |tokens| Names { variables, known, defined: &[] }.formula(&parse_formula(tokens)?))
}

/// Reads named formulas of the index of a site, such as `a = 1; b = i/n`.
///
/// # Errors
/// The first mistake.
pub fn formulas(text: &str, known: &NamedConstants) -> Result<Vec<(String, Formula)>, NoFormula> {
    read(text, |tokens| {
        let names = Names { variables: &OF_SITES, known, defined: &[] };
        let formulas = parse_formulas(tokens)?.into_iter();
        formulas.map(|(name, formula)| Ok((name.text, names.formula(&formula)?))).collect()
    })
}

fn read<R>(text: &str, read: impl FnOnce(&[Token]) -> Result<R, Diagnostic>) -> Result<R, NoFormula> {
    read(&lex(text).tokens).map_err(|mistake| NoFormula { text: text.to_owned(), mistake })
}

struct Names<'a> {
    variables: &'a [&'a str],
    known: &'a NamedConstants,
    /// Named formulas, with the nodes of their values in the program.
    defined: &'a [(&'a str, Node)],
}

impl Names<'_> {
    fn formula(&self, expr: &Expr<FormulaSyntax>) -> Result<Formula, Diagnostic> {
        let mut builder = Builder::default();
        let value = self.lower(&mut builder, expr)?;
        Ok(Formula::new(builder.finish(&[value]), self.variables.len(), self.known))
    }

    fn read(&self, builder: &mut Builder, text: &str) -> Result<Node, NoFormula> {
        read(text, |tokens| self.lower(builder, &parse_formula(tokens)?))
    }

    fn lower(&self, builder: &mut Builder, expr: &Expr<FormulaSyntax>) -> Result<Node, Diagnostic> {
        let operation = match &expr.kind {
            ExprKind::Number(value) => Operation::Constant(value.clone()),
            ExprKind::Name(name) => return self.named(builder, name, expr.span),
            ExprKind::Sum(terms) => {
                let terms = terms.iter().map(|term| (term.negative, &term.expr));
                return self.chain(builder, terms, Operation::Add, Operation::Subtract);
            }
            ExprKind::Product(factors) => {
                let factors = factors.iter().map(|factor| (factor.divides, &factor.expr));
                return self.chain(builder, factors, Operation::Multiply, Operation::Divide);
            }
            ExprKind::Negation(inner) => Operation::Negate(self.lower(builder, inner)?),
            ExprKind::Power(base, exponent) => {
                let base = self.lower(builder, base)?;
                Operation::Call(
                    Called::Power,
                    base,
                    builder.push(Operation::Constant(Rational::from(*exponent))),
                )
            }
            ExprKind::Special(FormulaSyntax::Power(parts)) => {
                let [base, exponent] = &**parts;
                let base = self.lower(builder, base)?;
                Operation::Call(Called::Power, base, self.lower(builder, exponent)?)
            }
            ExprKind::Special(FormulaSyntax::Call { function, arguments }) => {
                let (function, argument) = self.call(builder, function, arguments, expr.span)?;
                let argument = self.lower(builder, argument)?;
                Operation::Call(function, argument, argument)
            }
        };
        Ok(builder.push(operation))
    }

    /// Combines operands from left to right: those with the flag `true` by `inverse` (such as −),
    /// the others by `operator` (such as +).
    fn chain<'a>(
        &self,
        builder: &mut Builder,
        operands: impl Iterator<Item = (bool, &'a Expr<FormulaSyntax>)>,
        operator: fn(Node, Node) -> Operation,
        inverse: fn(Node, Node) -> Operation,
    ) -> Result<Node, Diagnostic> {
        let mut joined = None;
        for (is_inverse, operand) in operands {
            let operand = self.lower(builder, operand)?;
            joined = Some(match joined {
                None => operand,
                Some(joined) => builder.push(if is_inverse { inverse } else { operator }(joined, operand)),
            });
        }
        Ok(joined.expect("a sum has terms, and a product factors"))
    }

    fn named(&self, builder: &mut Builder, name: &str, span: Span) -> Result<Node, Diagnostic> {
        let variable = self.variables.iter().position(|variable| *variable == name);
        let known = self.known.iter().position(|(known, _)| known == name);
        let input = variable.or_else(|| known.map(|known| self.variables.len() + known));
        let defined = self.defined.iter().find(|(defined, _)| *defined == name);
        match (input, defined) {
            (Some(input), _) => Ok(builder.input(input)),
            (None, Some((_, value))) => Ok(*value),
            (None, None) if name == "pi" => {
                let pi = Rational::from_f64(PI).expect("a finite number");
                Ok(builder.push(Operation::Constant(pi)))
            }
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

    fn call<'a>(
        &self,
        builder: &mut Builder,
        name: &str,
        arguments: &'a [Expr<FormulaSyntax>],
        span: Span,
    ) -> Result<(Called, &'a Expr<FormulaSyntax>), Diagnostic> {
        let Some(index) = FUNCTIONS.iter().position(|(known, _)| *known == name) else {
            let help = match self.named(builder, name, span) {
                Ok(_) => format!("for a product write `{name}*(…)`"),
                Err(_) => format!("there are {}", functions()),
            };
            return Err(mistake(span, format!("`{name}(…)` calls no function that is known here"), help));
        };
        match arguments {
            [argument] => Ok((Called::Named(index), argument)),
            _ => {
                let message = format!("`{name}` is a function of one number, not of {}", arguments.len());
                Err(mistake(span, message, format!("write `{name}(…)` without a comma")))
            }
        }
    }
}

fn mistake(span: Span, message: String, help: String) -> Diagnostic {
    Diagnostic::new(Kind::UnknownName, span, message, help)
}

fn functions() -> String {
    FUNCTIONS.map(|(name, _)| name).join(", ")
}

#[cfg(test)]
mod tests {
    use kahan_algebra::arithmetic::{Exact, Float64};
    use kahan_algebra::rational::Rational;

    use super::{Formulas, formula, formula_of, formulas};

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
            ("i^-2*2^0.3", 3_f64.powi(-2) * libm::pow(2.0, 0.3)),
            ("1.1^i", 1.1_f64.powi(3)),
            ("1.1^1025", libm::pow(1.1, 1025.0)),
        ] {
            let found = formula(text, &[]).expect(text).at(3);
            assert_eq!(found.to_bits(), value.to_bits(), "{text}: {found}, not {value}");
        }
    }

    #[test]
    fn a_common_subexpression_is_computed_once() {
        let once = formula("sin(i/2)", &[]).expect("a formula").program.operations.len();
        let twice = formula("sin(i/2)*sin(i/2) - sin(i/2)", &[]).expect("a formula");
        assert_eq!(twice.program.operations.len(), once + 2);
        // 0 and −0 are different constants, although they compare as equal.
        let zeros = formula("m*i + z*i", &[("m".to_owned(), -0.0), ("z".to_owned(), 0.0)]);
        assert_eq!(zeros.expect("a formula").at(1).to_bits(), 0_f64.to_bits());
    }

    #[test]
    fn a_function_has_the_values_of_its_formula() {
        let wave = formula("1 + 1/2*cos(2*pi*i/7)^3", &[]).expect("a formula");
        let function = wave.clone().function();
        for site in 0..7 {
            assert_eq!(function(&[site as f64]).to_bits(), wave.at(site).to_bits(), "site {site}");
        }
    }

    #[test]
    fn formulas_together_have_the_values_of_each() {
        let texts = ["(x/3 + y)^3 - F*x", "x*y/7 - 1/10", "F^-2"];
        let together = Formulas::read(&["t", "x", "y"], &[("F", "1/x + y")], &texts).expect("formulas");
        let rows = together.needed();
        assert_eq!((rows.contains(&0), together.count()), (false, 3));
        let points = [[0.3, 1.7], [2.5, -0.7]];
        let inputs: Vec<f64> = rows.iter().flat_map(|row| points.map(|point| point[row - 1])).collect();
        let (mut found, mut exact) = ([0.0; 6], vec![Rational::ZERO; 6]);
        together.compute(&Float64, &inputs, &mut found).expect("floats");
        let fractions: Vec<Rational> = inputs.iter().filter_map(|value| Rational::from_f64(*value)).collect();
        together.compute(&Exact, &fractions, &mut exact).expect("no pole");
        for (place, value) in found.iter().enumerate() {
            let text = texts[place % 3].replace('F', "(1/x + y)");
            let alone = formula_of(&["x", "y"], &text, &[]).expect(&text).of(&points[place / 3]);
            assert_eq!(value.to_bits(), alone.to_bits(), "{text}");
            assert!((exact[place].to_f64() - alone).abs() <= 1e-14 * alone.abs(), "{text}");
        }
        let zeros = vec![Rational::ZERO; rows.len()];
        assert!(together.compute(&Exact, &zeros, &mut exact[..3]).is_none());
        assert!(Formulas::read(&["x"], &[], &["x + z"]).is_err());
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
