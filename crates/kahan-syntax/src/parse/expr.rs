//! Reads expressions by recursive descent.
//!
//! | binds | operator | note |
//! |---|---|---|
//! | tightest | `^` | `a^b^c` is refused; the exponent is an integer literal, `-` allowed before it |
//! | | unary `-` | `-x^2` is −(x²) |
//! | | `*`, `/` | from left to right |
//! | loosest | `+`, `-` | from left to right |
//!
//! Operands are numbers, names and expressions in parentheses. A [`Dialect`] adds indexed names
//! such as `x[i+1]` for families, or calls and arbitrary exponents for formulas. Notation of other
//! languages, such as `**`, is refused with a proposal.

use crate::diagnostics::Kind;
use crate::rational::Rational;
use crate::spelling::{LIFTS, NOT_QUADRATIC};
use crate::syntax::{Expr, ExprKind, Factor, Term};
use crate::token::{Span, TokenKind};

use super::cursor::Cursor;
use super::mistakes::{after_operand, missing_operand};
use super::number::parse_number;
use super::{Parsed, error};

const DEEPEST_NESTING: usize = 256;

/// Syntax in addition to arithmetic, such as function calls in formulas.
pub(super) trait Dialect: Sized {
    /// Reads the syntax that may follow a name at `span`. Returns `None` if the name stands alone.
    fn behind_name(cursor: &mut Cursor<'_>, name: &str, span: Span, depth: usize) -> Parsed<Option<Self>>;

    fn power(cursor: &mut Cursor<'_>, base: Expr<Self>, _: usize) -> Parsed<ExprKind<Self>> {
        Ok(ExprKind::Power(Box::new(base), exponent(cursor)?))
    }
}

/// Reads an expression up to `;`, `,`, a closing bracket, `when`, or the end of the tokens.
pub(super) fn parse_expr<X: Dialect>(cursor: &mut Cursor<'_>) -> Parsed<Expr<X>> {
    let expr = sum(cursor, 0)?;
    match cursor.unreadable() {
        Some(diagnostic) => Err(diagnostic),
        None => Ok(expr),
    }
}

pub(super) fn sum<X: Dialect>(cursor: &mut Cursor<'_>, depth: usize) -> Parsed<Expr<X>> {
    let term = |(negative, expr)| Term { negative, expr };
    chain(cursor, depth, ['+', '-'], product, |terms| ExprKind::Sum(terms.into_iter().map(term).collect()))
}

fn product<X: Dialect>(cursor: &mut Cursor<'_>, depth: usize) -> Parsed<Expr<X>> {
    let factor = |(divides, expr)| Factor { divides, expr };
    let join = |factors: Vec<(bool, Expr<X>)>| ExprKind::Product(factors.into_iter().map(factor).collect());
    chain(cursor, depth, ['*', '/'], unary, join)
}

/// Reads operands that are joined by an operator or its inverse, such as `+` and `-`. A flag tells
/// whether the inverse precedes the operand.
fn chain<X>(
    cursor: &mut Cursor<'_>,
    depth: usize,
    [operator, inverse]: [char; 2],
    operand: fn(&mut Cursor<'_>, usize) -> Parsed<Expr<X>>,
    join: impl Fn(Vec<(bool, Expr<X>)>) -> ExprKind<X>,
) -> Parsed<Expr<X>> {
    let first = operand(cursor, depth)?;
    let goes_on =
        |cursor: &Cursor<'_>| cursor.is_punctuation(0, operator) || cursor.is_punctuation(0, inverse);
    if !goes_on(cursor) {
        return Ok(first);
    }
    let mut span = first.span;
    let mut operands = Vec::with_capacity(3);
    operands.push((false, first));
    while goes_on(cursor) {
        let is_inverse = cursor.is_punctuation(0, inverse);
        if cursor.is_pair('*', '*') {
            let span = cursor.here().to(Span::token(cursor.position() + 1));
            return error(Kind::Syntax, span, "`**` is not a power here", "write `^`, as in `x^2`");
        }
        cursor.advance();
        let next = operand(cursor, depth)?;
        span = span.to(next.span);
        operands.push((is_inverse, next));
    }
    Ok(Expr { kind: join(operands), span })
}

fn unary<X: Dialect>(cursor: &mut Cursor<'_>, depth: usize) -> Parsed<Expr<X>> {
    if !cursor.is_punctuation(0, '-') {
        return power(cursor, depth);
    }
    check_depth(cursor, depth)?;
    let sign = cursor.here();
    cursor.advance();
    let operand = unary(cursor, depth + 1)?;
    let span = sign.to(operand.span);
    Ok(Expr { kind: ExprKind::Negation(Box::new(operand)), span })
}

fn power<X: Dialect>(cursor: &mut Cursor<'_>, depth: usize) -> Parsed<Expr<X>> {
    let base = atom::<X>(cursor, depth)?;
    if !cursor.take('^') {
        return after_operand(cursor, base);
    }
    let start = base.span;
    let kind = X::power(cursor, base, depth)?;
    if cursor.is_punctuation(0, '^') {
        let (message, help) =
            ("`a^b^c` can be read in two ways", "write `(a^b)^c`, or multiply the exponents");
        return error(Kind::Exponent, start.to(cursor.here()), message, help);
    }
    after_operand(cursor, Expr { kind, span: start.to(cursor.behind()) })
}

fn exponent(cursor: &mut Cursor<'_>) -> Parsed<i64> {
    let help = || {
        format!("write an integer literal, as in `x^2`; of other powers {LIFTS}: {NOT_QUADRATIC} shows how")
    };
    let negative = cursor.take('-');
    let span = cursor.here();
    let found = cursor.describe_next();
    let Some(token) = cursor.peek(0).filter(|token| token.kind == TokenKind::Literal) else {
        let inside = if cursor.is_open(0, '(') { cursor.take_group().1 } else { &[] };
        let literal = match inside {
            [one] if !negative => parse_number(&one.text, span).ok(),
            _ => None,
        };
        let help =
            literal.filter(Rational::is_integer).map_or_else(help, |value| format!("write `^{value}`"));
        return error(Kind::Exponent, span, format!("an exponent is an integer literal, not {found}"), help);
    };
    let value = parse_number(&token.text, span)?;
    if !value.is_integer() || token.text.contains('.') {
        let help = if value.is_integer() { format!("write `{value}`") } else { help() };
        return error(Kind::Exponent, span, format!("the exponent {found} is not an integer"), help);
    }
    cursor.advance();
    let magnitude = value.as_i64().unwrap_or(i64::MAX);
    Ok(if negative { -magnitude } else { magnitude })
}

/// Reads a number, a name with what follows it, or an expression in parentheses.
pub(super) fn atom<X: Dialect>(cursor: &mut Cursor<'_>, depth: usize) -> Parsed<Expr<X>> {
    let span = cursor.here();
    let Some(token) = cursor.peek(0) else { return missing_operand(cursor) };
    match &token.kind {
        TokenKind::Literal => {
            let value = parse_number(&token.text, span)?;
            cursor.advance();
            Ok(Expr { kind: ExprKind::Number(value), span })
        }
        TokenKind::Identifier => {
            cursor.advance();
            let special = X::behind_name(cursor, &token.text, span, depth)?;
            let kind = special.map_or_else(|| ExprKind::Name(token.text.to_string()), ExprKind::Special);
            Ok(Expr { kind, span: span.to(cursor.behind()) })
        }
        TokenKind::Open('(') => {
            let inner = in_parentheses(cursor, depth, sum)?;
            Ok(Expr { kind: inner.kind, span: span.to(cursor.behind()) })
        }
        TokenKind::Open(bracket) => {
            let group = cursor.skip_group();
            let message = format!("`{bracket}` does not group a formula");
            error(Kind::Syntax, group, message, "write parentheses: `( … )`")
        }
        TokenKind::Punctuation('.') if cursor.peek(1).is_some_and(|next| next.kind == TokenKind::Literal) => {
            let digits = cursor.peek(1).map_or("", |next| &*next.text);
            let span = span.to(Span::token(span.last + 1));
            error(Kind::Number, span, format!("`.{digits}` is not a number"), format!("write `0.{digits}`"))
        }
        TokenKind::Punctuation('+') => {
            let help = "remove the `+`, or write the operand";
            error(Kind::Syntax, span, "a `+` needs an operand on its left", help)
        }
        TokenKind::Unreadable(why) => error(Kind::Syntax, span, why.message.clone(), why.help.clone()),
        _ => missing_operand(cursor),
    }
}

pub(super) fn in_parentheses<T>(
    cursor: &mut Cursor<'_>,
    depth: usize,
    inside: impl FnOnce(&mut Cursor<'_>, usize) -> Parsed<T>,
) -> Parsed<T> {
    check_depth(cursor, depth)?;
    let opening = cursor.here();
    cursor.advance();
    let inner = inside(cursor, depth + 1)?;
    if !cursor.is_close(')') {
        let found = cursor.describe_next();
        return error(Kind::Syntax, opening, format!("this `(` is not closed before {found}"), "write `)`");
    }
    cursor.advance();
    Ok(inner)
}

fn check_depth(cursor: &Cursor<'_>, depth: usize) -> Parsed<()> {
    if depth < DEEPEST_NESTING {
        return Ok(());
    }
    let message = format!("the expression nests deeper than {DEEPEST_NESTING} levels");
    let help = "remove parentheses that are not needed, or split the expression";
    error(Kind::TooLarge, cursor.here(), message, help)
}
