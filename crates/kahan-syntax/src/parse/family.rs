//! Reads families such as `for i in periodic { x[i]dot = …; }`, whose equations hold at every site
//! of a chain.

use crate::diagnostics::{Diagnostic, Diagnostics, Kind};
use crate::syntax::{Block, Boundary, Equation, FamilyHead, FamilySyntax, Name};
use crate::token::{Span, TokenKind};

use super::block::parse_definition;
use super::cursor::Cursor;
use super::expr::{Dialect, atom};
use super::mistakes::check_plain_name;
use super::number::parse_number;
use super::{Parsed, error};

const FAMILY_SHAPE: &str = "write `for i in periodic { x[i]dot = …; }`, or `for i in open { … }`";

const MAX_OFFSET: i64 = 64;

pub(super) fn begins(cursor: &Cursor<'_>) -> bool {
    cursor.identifier(0) == Some("for")
        && (cursor.identifier(2) == Some("in") || cursor.identifier(1).is_some() && cursor.index.is_none())
}

/// Reads a family. After a mistake in an equation, continues with the next equation.
pub(super) fn family(
    cursor: &mut Cursor<'_>,
    block: &mut Block,
    diagnostics: &mut Diagnostics,
) -> Parsed<()> {
    let start = cursor.here();
    cursor.advance();
    let found = cursor.identifier(0);
    let index = cursor.expect_name("the index of a site")?;
    if index.text != "i" {
        let message = format!("the index of a site is called `i`, not `{}`", index.text);
        diagnostics.report(Kind::Name, index.span, message, "write `for i in …` and `x[i]`");
        cursor.index = found.or(cursor.index);
    }
    if cursor.identifier(0) != Some("in") {
        return Err(cursor.missing(Kind::Syntax, cursor.here(), "`in`", FAMILY_SHAPE));
    }
    cursor.advance();
    let boundary = match cursor.identifier(0) {
        Some("periodic") => Boundary::Periodic,
        Some("open") => Boundary::Open,
        _ => {
            let found = cursor.describe_next();
            let message = format!("a chain is `periodic` or `open`, and {found} is neither");
            diagnostics.report(Kind::Syntax, cursor.here(), message, FAMILY_SHAPE);
            Boundary::Periodic
        }
    };
    cursor.advance();
    let span = start.to(cursor.behind());
    if !cursor.is_open(0, '{') {
        return Err(cursor.missing(Kind::Syntax, span.to(cursor.here()), "`{`", FAMILY_SHAPE));
    }
    cursor.advance();
    let equations_before = block.equations.len();
    while !cursor.is_at_end() && !cursor.is_close('}') {
        if let Err(diagnostic) = equation(cursor, block) {
            diagnostics.push(diagnostic);
            // Skip to the token after `;`, or to the `}` that closes the family.
            cursor.skip_until(|cursor| cursor.is_close('}') || cursor.is_punctuation(0, ';'));
            cursor.take(';');
        }
    }
    if cursor.is_at_end() {
        diagnostics.report(Kind::Syntax, span, "the `{` of this family is not closed", "write `}`");
    }
    cursor.advance();
    cursor.take(';');
    if block.family.is_some() {
        block.equations.truncate(equations_before);
        return error(Kind::Syntax, span, "a block has one family", "write its equations into the first one");
    }
    let equations_until = block.equations.len();
    block.family = Some(FamilyHead { boundary, span, equations_before, equations_until });
    Ok(())
}

fn equation(cursor: &mut Cursor<'_>, block: &mut Block) -> Parsed<()> {
    let array = cursor.expect_name("an equation")?;
    let is_at_site = cursor.is_open(0, '[') && cursor.index.is_some() && cursor.identifier(1) == cursor.index;
    if !is_at_site {
        let base = array.text.strip_suffix("dot").filter(|base| !base.is_empty()).unwrap_or(&array.text);
        let span = if cursor.is_open(0, '[') { array.span.to(cursor.skip_group()) } else { array.span };
        let message = "an equation of a family is that of site `i`";
        return error(Kind::Name, span, message, format!("write `{base}[i]dot = …;`"));
    }
    let group = cursor.skip_group();
    let span = array.span.to(group);
    if group.last - group.first != 2 {
        let help = format!("write `{}[i]dot = …;` and shift the other side", array.text);
        return error(Kind::Name, span, "the left side of an equation is at site `i`", help);
    }
    if cursor.identifier(0) != Some("dot") {
        let help = format!("write `{}[i]dot = …;`", array.text);
        let span = span.to(cursor.here());
        return error(Kind::Name, span, "this left-hand side does not end in `dot`", help);
    }
    cursor.advance();
    let state = Name { text: array.text, span: span.to(cursor.behind()) };
    let (value, outcome) = parse_definition(cursor);
    block.equations.push(Equation { state, value });
    outcome
}

impl Dialect for FamilySyntax {
    fn behind_name(cursor: &mut Cursor<'_>, name: &str, span: Span, depth: usize) -> Parsed<Option<Self>> {
        if cursor.index.is_some() && cursor.is_open(0, '[') {
            let offset = offset(cursor, name, span)?;
            return Ok(Some(FamilySyntax::Site { array: name.to_owned(), offset }));
        }
        if cursor.index.is_some() && name == "sum" && cursor.is_open(0, '(') {
            return Ok(Some(FamilySyntax::OverSites(Box::new(atom(cursor, depth)?))));
        }
        check_plain_name(cursor, name, span)?;
        Ok(None)
    }
}

/// Reads the index in `x[i+1]`, after the name of the array. Returns the distance from site i.
fn offset(cursor: &mut Cursor<'_>, array: &str, span: Span) -> Parsed<i64> {
    let opening = cursor.position();
    let group = cursor.skip_group();
    let end = cursor.position();
    let wrong = |message: &str| {
        let help = format!("write `{array}[i]`, `{array}[i+1]`, `{array}[i-2]`: `i` and an integer");
        error(Kind::Syntax, span.to(group), message, help)
    };
    let token = |place: usize| cursor.before(end - place).filter(|_| place + 1 < end);
    let index = token(opening + 1);
    if index.is_none_or(|index| index.kind != TokenKind::Identifier || Some(&*index.text) != cursor.index) {
        return wrong("the index of a site is `i`, or `i` and an integer");
    }
    match end - opening {
        3 => Ok(0),
        5 => {
            let sign = match token(opening + 2).map(|token| &token.kind) {
                Some(TokenKind::Punctuation('+')) => 1,
                Some(TokenKind::Punctuation('-')) => -1,
                _ => return wrong("an offset is added to `i` or subtracted from it"),
            };
            let literal = token(opening + 3).filter(|token| token.kind == TokenKind::Literal);
            let place = Span::token(opening + 3);
            let value = match literal {
                Some(literal) => parse_number(&literal.text, place)?,
                None => return wrong("an offset is an integer literal"),
            };
            let Some(offset) = value.as_i64().filter(|_| value.is_integer()) else {
                return wrong("this offset is no integer");
            };
            if offset > MAX_OFFSET {
                return wrong(&format!("neighbours farther than {MAX_OFFSET} sites are not read"));
            }
            Ok(sign * offset)
        }
        _ => wrong("an index is `i` and one integer"),
    }
}

pub(super) fn outside(cursor: &Cursor<'_>) -> Diagnostic {
    let message = "an equation at a site stands in the braces of its family";
    Diagnostic::new(Kind::Syntax, cursor.here(), message, FAMILY_SHAPE)
}
