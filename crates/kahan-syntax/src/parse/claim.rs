//! Reads the claims `integral`, `density`, `bracket` and `drift`, with their conditions, and
//! `hamiltonian` in families.

use std::mem;

use crate::diagnostics::Kind;
use crate::syntax::{Block, Claim, ClaimBody, ClaimKind, Condition, Name, TensorEntry};

use super::block::{equals, semicolon};
use super::cursor::{Cursor, ExpressionEnd};
use super::expr::parse_expr;
use super::{Parsed, error};

pub(super) fn claim<X>(cursor: &mut Cursor<'_>, block: &mut Block<X>, kind: ClaimKind) -> Parsed<()> {
    cursor.advance();
    let name = cursor.expect_name("the name of a claim")?;
    let mut claim = Claim { kind, name, body: None, conditions: Vec::new() };
    let outcome = claim_body(cursor, &mut claim);
    block.claims.push(claim);
    outcome
}

pub(super) fn hamiltonian<X>(cursor: &mut Cursor<'_>, block: &mut Block<X>) -> Parsed<()> {
    let outcome = claim(cursor, block, ClaimKind::Integral);
    block.hamiltonians.extend(block.claims.pop());
    outcome
}

/// Reads the rest of a claim after its name. The body is set only if all of it could be read.
fn claim_body(cursor: &mut Cursor<'_>, claim: &mut Claim) -> Parsed<()> {
    let body = match claim.kind {
        ClaimKind::Bracket => ClaimBody::Tensor(entries(cursor, &claim.name)?),
        ClaimKind::Drift => recurrence(cursor, &claim.name)?,
        ClaimKind::Integral | ClaimKind::Density => {
            equals(cursor)?;
            ClaimBody::Function(parse_expr(cursor)?)
        }
    };
    cursor.end =
        if claim.kind == ClaimKind::Bracket { ExpressionEnd::Item } else { ExpressionEnd::Semicolon };
    let outcome = conditions(cursor, &mut claim.conditions);
    cursor.end = ExpressionEnd::Semicolon;
    outcome?;
    if claim.kind == ClaimKind::Bracket {
        cursor.take(';');
    } else {
        semicolon(cursor)?;
    }
    claim.body = Some(body);
    Ok(())
}

/// Reads `= expr by expr`. An operand may have the name `by`.
fn recurrence(cursor: &mut Cursor<'_>, name: &Name) -> Parsed<ClaimBody> {
    equals(cursor)?;
    let end = mem::replace(&mut cursor.end, ExpressionEnd::By);
    let function = parse_expr(cursor);
    cursor.end = end;
    let function = function?;
    if cursor.identifier(0) != Some("by") {
        let help =
            format!("write the next value behind `by`, as in `drift {0} = … by {0} - 2*eps;`", name.text);
        return Err(cursor.missing(Kind::Claim, function.span.to(cursor.here()), "`by`", help));
    }
    cursor.advance();
    Ok(ClaimBody::Recurrence { function, next: parse_expr(cursor)? })
}

fn entries(cursor: &mut Cursor<'_>, name: &Name) -> Parsed<Vec<TensorEntry>> {
    if !cursor.is_open(0, '{') {
        let help = format!("write `bracket {} {{ {{x,y}} = …; }}`", name.text);
        return Err(cursor.missing(Kind::Claim, name.span.to(cursor.here()), "`{`", help));
    }
    cursor.advance();
    let mut entries = Vec::new();
    while !cursor.is_close('}') {
        match entry(cursor) {
            Ok(entry) => entries.push(entry),
            Err(diagnostic) => {
                leave_group(cursor);
                return Err(diagnostic);
            }
        }
    }
    cursor.advance();
    Ok(entries)
}

fn entry(cursor: &mut Cursor<'_>) -> Parsed<TensorEntry> {
    let wrong =
        |cursor: &Cursor<'_>| cursor.missing(Kind::Claim, cursor.here(), "an entry", "write `{x,y} = …;`");
    if !cursor.is_open(0, '{') {
        return Err(wrong(cursor));
    }
    cursor.advance();
    let row = cursor.expect_name("a state")?;
    if !cursor.take(',') {
        return Err(wrong(cursor));
    }
    let column = cursor.expect_name("a state")?;
    if !cursor.is_close('}') {
        return Err(wrong(cursor));
    }
    cursor.advance();
    equals(cursor)?;
    let value = parse_expr(cursor)?;
    semicolon(cursor)?;
    Ok(TensorEntry { row, column, value })
}

fn leave_group(cursor: &mut Cursor<'_>) {
    while !cursor.is_at_end() && !cursor.begins_item(0) {
        if cursor.is_close('}') {
            cursor.advance();
            if !cursor.is_punctuation(0, '=') && !cursor.is_punctuation(0, ',') {
                return;
            }
        } else {
            cursor.advance();
        }
    }
}

fn conditions(cursor: &mut Cursor<'_>, conditions: &mut Vec<Condition>) -> Parsed<()> {
    if cursor.identifier(0) != Some("when") {
        return Ok(());
    }
    cursor.advance();
    if cursor.is_at_end() || cursor.is_punctuation(0, ';') {
        let help = "write one, as in `when eps = 1` or `when c = -a - b`, or remove `when`";
        return error(Kind::Claim, cursor.behind(), "there is no relation behind `when`", help);
    }
    loop {
        let end = mem::replace(&mut cursor.end, ExpressionEnd::Equals);
        let left = parse_expr(cursor);
        cursor.end = end;
        let left = left?;
        equals(cursor)?;
        conditions.push(Condition { left, right: parse_expr(cursor)? });
        if !cursor.take(',') {
            return Ok(());
        }
    }
}
