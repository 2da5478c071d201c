//! Parses statements with the parser of `kahan!`.

use kahan_algebra::lexer::lex;
use kahan_algebra::parse::parse_formula;
use kahan_algebra::rational::Rational;
use kahan_algebra::syntax::{Expr, ExprKind, FormulaSyntax};
use kahan_algebra::token::{Token, TokenKind};

use super::{Definition, Formula, Item, Relation, Statement};

/// Parses a statement, or returns the mistake and the text.
pub(crate) fn parse(text: &str) -> Result<Statement, String> {
    let tokens = lex(text).tokens;
    let items = tokens.split(|token| token.kind == TokenKind::Punctuation(';'));
    let items = items.filter(|tokens| !tokens.is_empty()).map(item).collect::<Result<_, _>>();
    Ok(Statement { items: items.map_err(|what| format!("{what} in `{text}`"))? })
}

fn item(tokens: &[Token]) -> Result<Item, String> {
    // The signs `:`, `~`, `!` and `=` occur in no formula, so the first one ends the left side.
    let is_sign = |token: &Token| matches!(token.kind, TokenKind::Punctuation(':' | '~' | '!' | '='));
    let (left, rest) = tokens.split_at(tokens.iter().position(is_sign).unwrap_or(tokens.len()));
    let sign = |index: usize| rest.get(index).map_or("", |token| &*token.text);
    let (relation, right) = match (sign(0), sign(1)) {
        (":", "=") => {
            let (name, parameters) = signature(formula(left)?)?;
            return Ok(Item::Definition(Definition { name, parameters, body: formula(&rest[2..])? }));
        }
        ("=", _) => (Relation::Equal, &rest[1..]),
        ("~", _) => (Relation::Approximate, &rest[1..]),
        ("!", "=") => (Relation::Different, &rest[2..]),
        _ => return Err("there is none of `:=`, `=`, `~` and `!=`".to_owned()),
    };
    let literal = right.iter().rfind(|token| token.kind == TokenKind::Literal);
    let (left, right) = (formula(left)?, formula(right)?);
    let digit = literal.and_then(|token| last_digit(&token.text)).filter(|_| right.as_number().is_some());
    Ok(Item::Relation { left, relation, right, digit })
}

fn formula(tokens: &[Token]) -> Result<Formula, String> {
    parse_formula(tokens).map(Formula::from).map_err(|mistake| mistake.message)
}

/// Converts an expression and drops its source positions.
impl From<Expr<FormulaSyntax>> for Formula {
    fn from(expr: Expr<FormulaSyntax>) -> Self {
        match expr.kind {
            ExprKind::Number(value) => Formula::Number(value),
            ExprKind::Name(name) => Formula::Name(name),
            ExprKind::Sum(terms) => {
                Formula::Sum(terms.into_iter().map(|term| (term.negative, term.expr.into())).collect())
            }
            ExprKind::Product(factors) => Formula::Product(
                factors.into_iter().map(|factor| (factor.divides, factor.expr.into())).collect(),
            ),
            ExprKind::Negation(inner) => Formula::Negation(Box::new((*inner).into())),
            ExprKind::Power(base, exponent) => Formula::from(*base).raised_to(exponent),
            ExprKind::Special(FormulaSyntax::Power(parts)) => {
                let [base, exponent] = parts.map(Formula::from);
                Formula::Power(Box::new(base), Box::new(exponent))
            }
            ExprKind::Special(FormulaSyntax::Call { function, arguments }) => {
                Formula::Call(function, arguments.into_iter().map(Formula::from).collect())
            }
        }
    }
}

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

/// Returns the value of one unit in the last written place: 1/100 for `3.14`, 1 for `3`.
fn last_digit(literal: &str) -> Option<Rational> {
    let (mantissa, exponent) = literal.split_once(['e', 'E']).unwrap_or((literal, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    Rational::from(10).pow(exponent.parse::<i32>().ok()? - i32::try_from(decimals).ok()?)
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn mistakes_name_the_statement() {
        for (text, message) in [
            ("x", "there is none of"),
            ("x ! 1", "there is none of"),
            ("f(1) := 2", "a definition needs a name"),
            ("x = 1 = 2", "the formula should end here"),
            ("x = 2 y", "two operands stand side by side"),
            ("x := ; y = 1", "an operand is missing"),
        ] {
            let why = parse(text).expect_err(text);
            assert!(why.starts_with(message) && why.ends_with(&format!(" in `{text}`")), "{why}");
        }
        assert_eq!(parse("N(n) := n + 1; N(2) != 2;").expect("a statement").items.len(), 2);
    }
}
