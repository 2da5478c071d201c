//! Text to statements, by precedence: sums, products, signs, powers, atoms.

use kahan_algebra::lexer::lex;
use kahan_algebra::rational::Rational;
use kahan_algebra::token::{Token, TokenKind};

use super::{Definition, Formula, Item, Relation, Statement};

/// Reads a statement.
///
/// # Errors
/// What is wrong, with the place in words.
pub(crate) fn parse(text: &str) -> Result<Statement, String> {
    let tokens = lex(text).tokens;
    let mut parser = Parser { tokens: &tokens, at: 0 };
    let mut statement = Statement::default();
    while parser.at < tokens.len() {
        statement.items.push(parser.item().map_err(|what| format!("{what} in `{text}`"))?);
        if !parser.eat(";") && parser.at < tokens.len() {
            return Err(format!("`;` expected before `{}` in `{text}`", parser.peek()));
        }
    }
    Ok(statement)
}

struct Parser<'a> {
    tokens: &'a [Token],
    at: usize,
}

impl Parser<'_> {
    fn peek(&self) -> &str {
        self.tokens.get(self.at).map_or("", |token| token.text.as_str())
    }

    fn eat(&mut self, text: &str) -> bool {
        let found = self.peek() == text;
        self.at += usize::from(found);
        found
    }

    fn expect(&mut self, text: &str) -> Result<(), String> {
        if self.eat(text) { Ok(()) } else { Err(format!("`{text}` expected, not `{}`,", self.peek())) }
    }

    fn item(&mut self) -> Result<Item, String> {
        let left = self.sum()?;
        if self.eat(":") {
            self.expect("=")?;
            let (name, parameters) = signature(left)?;
            return Ok(Item::Definition(Definition { name, parameters, body: self.sum()? }));
        }
        let relation = if self.eat("~") {
            Relation::Approximate
        } else if self.eat("!") {
            self.expect("=")?;
            Relation::Different
        } else {
            self.expect("=")?;
            Relation::Equal
        };
        let first = self.at;
        let right = self.sum()?;
        let literal = self.tokens[first..self.at].iter().rfind(|token| token.kind == TokenKind::Literal);
        let digit = literal.and_then(|token| last_digit(&token.text)).filter(|_| right.as_number().is_some());
        Ok(Item::Relation { left, relation, right, digit })
    }

    fn sum(&mut self) -> Result<Formula, String> {
        self.chain(Self::product, ["+", "-"], Formula::Sum)
    }

    fn product(&mut self) -> Result<Formula, String> {
        self.chain(Self::signed, ["*", "/"], Formula::Product)
    }

    /// Operands between signs, the second of which marks what is subtracted, or divides.
    fn chain(
        &mut self,
        operand: fn(&mut Self) -> Result<Formula, String>,
        signs: [&str; 2],
        whole: fn(Vec<(bool, Formula)>) -> Formula,
    ) -> Result<Formula, String> {
        let mut parts = vec![(false, operand(self)?)];
        while let Some(sign) = signs.iter().position(|sign| *sign == self.peek()) {
            self.at += 1;
            parts.push((sign == 1, operand(self)?));
        }
        Ok(if parts.len() == 1 { parts.remove(0).1 } else { whole(parts) })
    }

    fn signed(&mut self) -> Result<Formula, String> {
        if self.eat("-") { Ok(Formula::Negation(Box::new(self.power()?))) } else { self.power() }
    }

    fn power(&mut self) -> Result<Formula, String> {
        let base = self.atom()?;
        if !self.eat("^") {
            return Ok(base);
        }
        Ok(Formula::Power(Box::new(base), Box::new(self.atom()?)))
    }

    fn atom(&mut self) -> Result<Formula, String> {
        let Some(token) = self.tokens.get(self.at) else {
            return Err("an operand is missing at the end".into());
        };
        self.at += 1;
        match &token.kind {
            TokenKind::Literal => {
                let value = Rational::parse(&token.text);
                value.map(Formula::Number).ok_or_else(|| format!("`{}` is no number", token.text))
            }
            TokenKind::Identifier if self.eat("(") => {
                let mut arguments = vec![self.sum()?];
                while self.eat(",") {
                    arguments.push(self.sum()?);
                }
                self.expect(")")?;
                Ok(Formula::Call(token.text.clone(), arguments))
            }
            TokenKind::Identifier => Ok(Formula::Name(token.text.clone())),
            TokenKind::Open('(') => {
                let inner = self.sum()?;
                self.expect(")")?;
                Ok(inner)
            }
            _ => Err(format!("an operand is missing before `{}`", token.text)),
        }
    }
}

/// The left-hand side of a definition.
fn signature(left: Formula) -> Result<(String, Vec<String>), String> {
    let wrong =
        || Err("a definition needs a name, or a name with names in parentheses, before `:=`".to_owned());
    match left {
        Formula::Name(name) => Ok((name, Vec::new())),
        Formula::Call(name, arguments) => {
            let mut parameters = Vec::new();
            for argument in arguments {
                let Formula::Name(parameter) = argument else { return wrong() };
                parameters.push(parameter);
            }
            Ok((name, parameters))
        }
        _ => wrong(),
    }
}

/// The unit of the last written digit: 1/100 for `3.14`, 1 for `3`.
fn last_digit(literal: &str) -> Option<Rational> {
    let (mantissa, exponent) = literal.split_once(['e', 'E']).unwrap_or((literal, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    Rational::from(10).pow(exponent.parse::<i32>().ok()? - i32::try_from(decimals).ok()?)
}
