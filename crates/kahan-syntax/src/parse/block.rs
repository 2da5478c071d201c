//! Reads the items of a block, which are constants, equations and claims.

use crate::diagnostics::Kind;
use crate::spelling::{derivative, without_dots};
use crate::syntax::{Block, ClaimKind, Constant, Equation, Expr, Name};
use crate::table::distinct;
use crate::token::{Span, TokenKind};

use super::claim::{claim, hamiltonian};
use super::cursor::Cursor;
use super::expr::{Dialect, parse_expr};
use super::keyword::wrong_keyword;
use super::{Parsed, error};

const ITEM_SHAPES: &str =
    "a block holds equations `xdot = …;`, constants `const c = …;` and claims `integral H = …;`";

/// Reads an item into the block. After a mistake, the cursor stays inside the item.
pub(super) fn parse_item<X: Dialect>(cursor: &mut Cursor<'_>, block: &mut Block<X>) -> Parsed<()> {
    if let Some(diagnostic) = cursor.unreadable() {
        return Err(diagnostic);
    }
    if cursor.take(';') {
        return error(Kind::Syntax, cursor.behind(), "a `;` that ends nothing", "remove it");
    }
    let Some(word) = cursor.identifier(0) else {
        return Err(cursor.missing(Kind::Syntax, cursor.here(), "an equation", ITEM_SHAPES));
    };
    let named = cursor.identifier(1).is_some();
    let kind = ClaimKind::of_keyword(word);
    match (word, kind) {
        ("const", _) if named => constant(cursor, block),
        ("hamiltonian", _) if named && cursor.index.is_some() => hamiltonian(cursor, block),
        (_, Some(kind)) if named => claim(cursor, block, kind),
        ("const", _) | (_, Some(_)) => {
            let next = Span::token(cursor.position() + usize::from(cursor.peek(1).is_some()));
            let (message, help) = (format!("this `{word}` has no name"), format!("write `{word} NAME = …;`"));
            error(Kind::Syntax, cursor.here().to(next), message, help)
        }
        ("pub" | "struct", _) => {
            let message = "the header stands at the beginning of a block, and a block has one";
            let help = "move it to the top, or write a second `kahan!` block";
            error(Kind::Header, cursor.here(), message, help)
        }
        _ if super::header::is_lift(cursor) => {
            let help =
                "write `lift pub struct Name { … }`, or `lift;` at the beginning of a block without a header";
            error(
                Kind::Header,
                cursor.here(),
                "`lift` stands in the header, at the beginning of a block",
                help,
            )
        }
        _ if cursor.is_open(1, '[') => Err(super::family::outside(cursor)),
        _ => match wrong_keyword(cursor, block) {
            Some(diagnostic) => Err(diagnostic),
            None => equation(cursor, block),
        },
    }
}

fn constant<X: Dialect>(cursor: &mut Cursor<'_>, block: &mut Block<X>) -> Parsed<()> {
    cursor.advance();
    let name = cursor.expect_name("the name of a constant")?;
    let (value, outcome) = parse_definition(cursor);
    block.constants.push(Constant { name, value });
    outcome
}

fn equation<X: Dialect>(cursor: &mut Cursor<'_>, block: &mut Block<X>) -> Parsed<()> {
    let left = cursor.expect_name("an equation")?;
    let state = state_of(cursor, block, left)?;
    let (value, outcome) = parse_definition(cursor);
    block.equations.push(Equation { state, value });
    outcome
}

/// Reads `= expr;`. If only the `;` is missing, the expression is returned nevertheless.
pub(super) fn parse_definition<X: Dialect>(cursor: &mut Cursor<'_>) -> (Option<Expr<X>>, Parsed<()>) {
    match equals(cursor).and_then(|()| parse_expr(cursor)) {
        Ok(value) => (Some(value), semicolon(cursor)),
        Err(mistake) => (None, Err(mistake)),
    }
}

fn state_of<X>(cursor: &Cursor<'_>, block: &mut Block<X>, left: Name) -> Parsed<Name> {
    let span = left.span;
    if let Some(state) = left.text.strip_suffix("dot") {
        if let Some((meant, order)) = derivative_of(cursor, state) {
            let message =
                format!("`{}` is the equation of a state `{state}`, which nothing else names", left.text);
            let help = derivative(&meant, order, |name| cursor.mentions(name));
            broken_equation(block, left, meant);
            return error(Kind::Name, span, message, help);
        }
        if !state.is_empty() {
            return Ok(Name { text: state.to_owned(), span });
        }
        let help = "write the variable before it, as in `xdot`";
        return error(Kind::Name, span, "`dot` alone names no variable", help);
    }
    let text = left.text.clone();
    if cursor.peek(0).is_some_and(|next| matches!(next.kind, TokenKind::Unreadable(_))) {
        block.misspelt_states.push(left);
        return Err(cursor.unreadable().expect("the next token is unreadable"));
    }
    let quotient = text.strip_prefix('d').filter(|state| !state.is_empty() && cursor.is_punctuation(0, '/'));
    let help = match quotient {
        Some(state) => {
            block.misspelt_states.push(left.clone());
            derivative(state, 1, |_| false)
        }
        None if cursor.is_punctuation(0, '=') => {
            let (state, order) = probable_derivative(cursor, &text);
            let help = derivative(&state, order, |name| cursor.mentions(name));
            broken_equation(block, left, state);
            help
        }
        None => {
            block.misspelt_states.push(left);
            ITEM_SHAPES.to_owned()
        }
    };
    error(Kind::Name, span, format!("`{text}` is no left-hand side: it does not end in `dot`"), help)
}

/// Records the misspelt `left`, and the state `meant` with an equation without right-hand side.
fn broken_equation<X>(block: &mut Block<X>, left: Name, meant: String) {
    let state = Name { text: meant, span: left.span };
    block.equations.push(Equation { state: state.clone(), value: None });
    block.misspelt_states.extend([left, state]);
}

/// Returns the state and the derivative's order that `x_dot`, `xddot` or `x_ddot` probably means.
fn derivative_of(cursor: &Cursor<'_>, state: &str) -> Option<(String, usize)> {
    let single = state.trim_end_matches('d');
    let order = 1 + state.len() - single.len();
    let meant = single.trim_end_matches('_');
    let is_state = meant == state || meant.is_empty() || cursor.uses(state);
    let is_marked = meant != single || probable_state(cursor, meant);
    (!is_state && is_marked).then(|| (meant.to_owned(), order))
}

/// Returns whether a name is probably a state: a name that the block uses, or a single letter.
fn probable_state(cursor: &Cursor<'_>, name: &str) -> bool {
    cursor.uses(name) || name.chars().count() == 1
}

/// Returns the state and the derivative's order that `xdto`, `xDot`, `dxdt` or `ẋ` probably means.
fn probable_derivative(cursor: &Cursor<'_>, left: &str) -> (String, usize) {
    if let Some(dotted) = without_dots(left) {
        return dotted;
    }
    let leibniz = left.strip_prefix('d').and_then(|rest| rest.strip_suffix("dt"));
    let twisted = left.char_indices().rev().nth(2).and_then(|(at, _)| {
        let ending = distinct(left[at..].to_lowercase().chars());
        (ending == ['d', 'o', 't']).then_some(&left[..at])
    });
    let in_words = || left.to_lowercase().ends_with("prime").then(|| &left[..left.len() - "prime".len()]);
    let is_state = |name: &&str| probable_state(cursor, name) && !cursor.uses(left);
    let differential = || left.strip_prefix(['d', 'D']).map(|rest| rest.trim_matches('_')).filter(is_state);
    let partial = || left.strip_suffix("_t").filter(is_state);
    let state = leibniz.or(twisted).or_else(in_words).or_else(differential).or_else(partial);
    let state = state.map(|state| state.trim_matches('_')).filter(|state| !state.is_empty());
    (state.unwrap_or(left).to_owned(), 1)
}

pub(super) fn equals(cursor: &mut Cursor<'_>) -> Parsed<()> {
    let doubled = cursor.is_pair('=', '=');
    if cursor.take('=') {
        if doubled {
            let span = cursor.behind().to(cursor.here());
            return error(Kind::Syntax, span, "`==` compares, it does not define", "write `=`");
        }
        return Ok(());
    }
    if let Some(diagnostic) = cursor.unreadable() {
        return Err(diagnostic);
    }
    let span = cursor.behind().to(cursor.here());
    let help = match cursor.before(1) {
        Some(name) if cursor.is_open(0, '(') => format!("write `{} = …`, without arguments", name.text),
        _ => "write `=` after the name".to_owned(),
    };
    Err(cursor.missing(Kind::Syntax, span, "`=`", help))
}

pub(super) fn semicolon(cursor: &mut Cursor<'_>) -> Parsed<()> {
    if cursor.take(';') {
        return Ok(());
    }
    let span = cursor.behind().to(cursor.here());
    Err(cursor.missing(Kind::Syntax, span, "`;`", "end the line with `;`"))
}
