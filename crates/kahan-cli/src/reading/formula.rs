//! Formulas in floats: of the index of a site, `1 + 1/2*cos(2*pi*i/n)`, or of the variables of a
//! state.
//!
//! In: text in the language of `kahan!`, with functions. Out: a value at each site or state. Powers
//! and signs bind as in the language: `-x^2` is −(x²), and `a^b^c` needs parentheses.

use std::f64::consts::PI;

use kahan_algebra::diagnostics::{Diagnostic, Kind};
use kahan_algebra::lexer::{Lexed, lex};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::report;
use kahan_algebra::token::{Span, Token, TokenKind};

use crate::printing::Refusal;

/// A function of one number.
type Function = fn(f64) -> f64;

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
pub(crate) enum Formula {
    Number(f64),
    /// The variable with this index.
    Variable(usize),
    Negate(Box<Formula>),
    Binary(char, Box<(Formula, Formula)>),
    Call(Function, Box<Formula>),
}

impl Formula {
    /// The value at a site, whose index is the only variable.
    pub(super) fn at(&self, site: usize) -> f64 {
        self.of(&[site as f64])
    }

    /// The value at these variables.
    pub(crate) fn of(&self, variables: &[f64]) -> f64 {
        match self {
            Self::Number(value) => *value,
            Self::Variable(k) => variables[*k],
            Self::Negate(of) => -of.of(variables),
            Self::Call(function, of) => function(of.of(variables)),
            Self::Binary(sign, sides) => {
                let (a, b) = (sides.0.of(variables), sides.1.of(variables));
                match sign {
                    '+' => a + b,
                    '-' => a - b,
                    '*' => a * b,
                    '/' => a / b,
                    _ if b.fract() == 0.0 && b.abs() <= 1024.0 => a.powi(b as i32),
                    _ => a.powf(b),
                }
            }
        }
    }

    /// The last of the variables that it names; `None` where it is one number everywhere.
    pub(crate) fn last_variable(&self) -> Option<usize> {
        match self {
            Self::Number(_) => None,
            Self::Variable(k) => Some(*k),
            Self::Negate(of) | Self::Call(_, of) => of.last_variable(),
            Self::Binary(_, sides) => sides.0.last_variable().max(sides.1.last_variable()),
        }
    }
}

/// Names that stand for numbers, beside `pi`.
pub(super) type Known = [(String, f64)];

/// The names of a formula of sites.
const OF_SITES: [&str; 1] = ["i"];

/// One formula of the index of a site; `option` is what the text is called in reports.
pub(super) fn formula(text: &str, known: &Known, option: &str) -> Result<Formula, Refusal> {
    formula_of(&OF_SITES, text, known, option)
}

/// One formula of these variables.
pub(super) fn formula_of(
    variables: &[&str],
    text: &str,
    known: &Known,
    option: &str,
) -> Result<Formula, Refusal> {
    read(text, option, |lexed| {
        let mut reader = Reader { tokens: &lexed.tokens, at: 0, variables, known };
        let formula = reader.sum(0)?;
        reader.end().map(|()| formula)
    })
}

/// Formulas of the index of a site by name: `a = 1; b = i/n`.
pub(super) fn formulas(text: &str, known: &Known, option: &str) -> Result<Vec<(String, Formula)>, Refusal> {
    read(text, option, |lexed| {
        let mut reader = Reader { tokens: &lexed.tokens, at: 0, variables: &OF_SITES, known };
        let mut formulas = Vec::new();
        while reader.at < reader.tokens.len() {
            let name = reader.name()?;
            if !reader.takes('=') {
                return Err(reader.mistake("a `=` is missing", "write `x = 1 + i/n`"));
            }
            formulas.push((name, reader.sum(0)?));
            if !reader.takes(';') {
                reader.end()?;
            }
        }
        Ok(formulas)
    })
}

fn read<R>(
    text: &str,
    option: &str,
    read: impl FnOnce(&Lexed) -> Result<R, Diagnostic>,
) -> Result<R, Refusal> {
    /// More would overflow stacks.
    const LONGEST: usize = 10_000;

    let lexed = lex(text);
    if lexed.tokens.len() > LONGEST {
        return Err(Refusal::new(format!(
            "{option}: the formula is too long; write the numbers to a file F.npy"
        )));
    }
    read(&lexed).map_err(|mistake| Refusal::reports(report(&mistake, text, &lexed.ranges, option)))
}

struct Reader<'a> {
    tokens: &'a [Token],
    at: usize,
    variables: &'a [&'a str],
    known: &'a Known,
}

/// How deep formulas may be nested, so that no stack overflows.
const DEEPEST: usize = 256;

impl Reader<'_> {
    fn kind(&self) -> Option<&TokenKind> {
        self.tokens.get(self.at).map(|token| &token.kind)
    }

    fn takes(&mut self, sign: char) -> bool {
        let is_it = matches!(self.kind(), Some(TokenKind::Punctuation(c) | TokenKind::Open(c) | TokenKind::Close(c)) if *c == sign);
        self.at += usize::from(is_it);
        is_it
    }

    fn takes_one_of(&mut self, signs: &[char]) -> Option<char> {
        signs.iter().copied().find(|sign| self.takes(*sign))
    }

    fn mistake(&self, message: &str, help: &str) -> Diagnostic {
        let place = self.at.min(self.tokens.len().saturating_sub(1));
        match self.kind() {
            Some(TokenKind::Unreadable { message, help }) => {
                Diagnostic::new(Kind::Syntax, Span::token(place), message, help)
            }
            _ => Diagnostic::new(Kind::Syntax, Span::token(place), message, help),
        }
    }

    fn name(&mut self) -> Result<String, Diagnostic> {
        if self.kind() != Some(&TokenKind::Identifier) {
            return Err(self.mistake("the name of an array is missing", "write `x = 1 + i/n`"));
        }
        self.at += 1;
        Ok(self.tokens[self.at - 1].text.clone())
    }

    /// Nothing may follow.
    fn end(&self) -> Result<(), Diagnostic> {
        if self.at == self.tokens.len() {
            return Ok(());
        }
        Err(self.mistake(
            "the formula should end here",
            "put an operator in between: `2*i`; formulas of several arrays are separated by `;`",
        ))
    }

    fn sum(&mut self, depth: usize) -> Result<Formula, Diagnostic> {
        if depth > DEEPEST {
            return Err(self.mistake("the formula is nested too deeply", "use fewer parentheses"));
        }
        let mut left = self.product(depth)?;
        while let Some(sign) = self.takes_one_of(&['+', '-']) {
            left = Formula::Binary(sign, Box::new((left, self.product(depth)?)));
        }
        Ok(left)
    }

    fn product(&mut self, depth: usize) -> Result<Formula, Diagnostic> {
        let mut left = self.signed(depth)?;
        while let Some(sign) = self.takes_one_of(&['*', '/']) {
            left = Formula::Binary(sign, Box::new((left, self.signed(depth)?)));
        }
        Ok(left)
    }

    fn signed(&mut self, depth: usize) -> Result<Formula, Diagnostic> {
        if self.takes('-') {
            return Ok(Formula::Negate(Box::new(self.nested_sign(depth)?)));
        }
        self.power(depth)
    }

    fn nested_sign(&mut self, depth: usize) -> Result<Formula, Diagnostic> {
        if depth > DEEPEST {
            return Err(self.mistake("the formula has too many signs", "leave some of them out"));
        }
        self.signed(depth + 1)
    }

    fn power(&mut self, depth: usize) -> Result<Formula, Diagnostic> {
        let base = self.atom(depth)?;
        if !self.takes('^') {
            return Ok(base);
        }
        let is_negative = self.takes('-');
        let exponent = self.atom(depth)?;
        if matches!(self.kind(), Some(TokenKind::Punctuation('^'))) {
            return Err(self.mistake("a power of a power", "write parentheses: `(a^b)^c`"));
        }
        let exponent = if is_negative { Formula::Negate(Box::new(exponent)) } else { exponent };
        Ok(Formula::Binary('^', Box::new((base, exponent))))
    }

    fn atom(&mut self, depth: usize) -> Result<Formula, Diagnostic> {
        let nothing =
            || self.mistake("a number, a name or a formula in parentheses is missing", "write `1 + i/n`");
        let Some(token) = self.tokens.get(self.at) else { return Err(nothing()) };
        match token.kind {
            TokenKind::Literal => {
                let number = Rational::parse(&token.text).map(|number| number.to_f64());
                let number = number.ok_or_else(|| {
                    self.mistake("this is no number", "write `2`, `0.5` or `1e-3`; a product is `2*i`")
                })?;
                self.at += 1;
                Ok(Formula::Number(number))
            }
            TokenKind::Open('(') => self.in_parentheses(depth),
            TokenKind::Identifier => {
                if let Some((_, function)) = FUNCTIONS.iter().find(|(name, _)| *name == token.text) {
                    self.at += 1;
                    return Ok(Formula::Call(*function, Box::new(self.in_parentheses(depth)?)));
                }
                let variable = self.variables.iter().position(|name| *name == token.text);
                let known = self.known.iter().find(|(name, _)| *name == token.text);
                let formula = match (token.text.as_str(), variable, known) {
                    (_, Some(variable), _) => Formula::Variable(variable),
                    (_, None, Some((_, value))) => Formula::Number(*value),
                    ("pi", None, None) => Formula::Number(PI),
                    (name, None, None) => {
                        let known = self.known.iter().map(|(name, _)| name.as_str());
                        let names = self.variables.iter().copied().chain(known);
                        let functions = FUNCTIONS.map(|(name, _)| name).join(", ");
                        return Err(self.mistake(
                            &format!("`{name}` is not known here"),
                            &format!(
                                "there are {}, pi, and the functions {functions}",
                                names.collect::<Vec<_>>().join(", ")
                            ),
                        ));
                    }
                };
                self.at += 1;
                Ok(formula)
            }
            _ => Err(nothing()),
        }
    }

    fn in_parentheses(&mut self, depth: usize) -> Result<Formula, Diagnostic> {
        if !self.takes('(') {
            return Err(self.mistake("a `(` is missing", "write the argument in parentheses: `sin(i)`"));
        }
        let inner = self.sum(depth + 1)?;
        if !self.takes(')') {
            return Err(self.mistake("a `)` is missing", "close the parenthesis"));
        }
        Ok(inner)
    }
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
        ] {
            let value = formula(text, &known, "--start").expect(text).at(3);
            assert!((value - at_three).abs() < 1e-15, "{text}: {value}");
        }
        assert_eq!(formula("i*0", &[], "").expect("a formula").last_variable(), Some(0));
        assert_eq!(formula("sin(1)^2", &[], "").expect("a formula").last_variable(), None);
        let named = formulas("x = i; y = 2;", &known, "--start").expect("two");
        assert_eq!(
            named.iter().map(|(name, formula)| (name.as_str(), formula.at(5))).collect::<Vec<_>>(),
            [("x", 5.0), ("y", 2.0)]
        );
    }

    #[test]
    fn mistakes_are_shown_where_they_stand() {
        let deep = "(".repeat(10_000);
        let signs = "-".repeat(10_000);
        for (text, part) in [
            ("", "missing"),
            ("1 +", "missing"),
            ("2 i", "should end here"),
            ("2i", "no number"),
            ("m + 1", "`m` is not known"),
            ("sin 1", "a `(` is missing"),
            ("(1", "a `)` is missing"),
            ("1^2^3", "write parentheses"),
            ("2 \u{b7} i", "error"),
            (&deep, "too deeply"),
            (&signs, "too many signs"),
        ] {
            let refusal = format!("{:?}", formula(text, &[], "--start").expect_err(text));
            assert!(refusal.contains(part), "{text}: {refusal}");
        }
        for text in ["x", "= 1", "x = 1 y = 2", "3 = x"] {
            assert!(formulas(text, &[], "--start").is_err(), "{text}");
        }
    }
}
