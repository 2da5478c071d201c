//! Parses the language of `kahan!` by recursive descent.
//!
//! Rust's expression parser is unsuitable, because in Rust `^` has lower precedence than `+`. After
//! a mistake the parser skips to the next `;` or item, so that it can report several mistakes at
//! once. The parser returns a block for any tokens and never panics.

mod block;
mod claim;
mod cursor;
mod expr;
mod family;
mod formula;
mod header;
mod keyword;
mod mistakes;
mod number;

use crate::diagnostics::{Diagnostic, Diagnostics, Kind};
use crate::syntax::{Block, ClaimBody, FormulaSyntax, Reference};
use crate::token::{Span, Token};

use cursor::Cursor;
pub use formula::{parse_formula, parse_formulas};
pub(crate) use mistakes::{is_function, is_statement};
pub(crate) use number::product;

type Parsed<T> = Result<T, Diagnostic>;

fn error<T>(kind: Kind, span: Span, message: impl Into<String>, help: impl Into<String>) -> Parsed<T> {
    Err(Diagnostic::new(kind, span, message, help))
}

/// Returns whether a block begins with `lift`. [`parse_lifted`] reads such a block.
#[must_use]
pub fn asks_for_lift(tokens: &[Token]) -> bool {
    let mut diagnostics = Diagnostics::default();
    let (_, block) = begin::<FormulaSyntax>(tokens, &mut diagnostics);
    // Drop these mistakes, because the caller parses the block again and reports them.
    drop(diagnostics.finish());
    block.lift.is_some()
}

/// Reads a block. The keyword `lift` at its beginning is reported as a mistake.
#[must_use]
pub fn parse(tokens: &[Token], diagnostics: &mut Diagnostics) -> Block {
    let (mut cursor, mut block) = begin(tokens, diagnostics);
    if let Some(lift) = block.lift {
        let help = "in Rust `kahan!` lifts it, in the command `kahan lift`, in Python `kahan.System(text, lift=True)`";
        diagnostics.report(
            Kind::Header,
            lift,
            "this block asks for a lift, and here blocks are read as they stand",
            help,
        );
        return block;
    }
    items(&mut cursor, &mut block, diagnostics, |cursor, block, diagnostics| {
        if family::begins(cursor) {
            family::family(cursor, block, diagnostics)
        } else {
            block::parse_item(cursor, block)
        }
    });
    block
}

/// Reads a block that is to be lifted, whose equations may contain functions and general powers.
#[must_use]
pub fn parse_lifted(tokens: &[Token], diagnostics: &mut Diagnostics) -> Block<FormulaSyntax> {
    let (mut cursor, mut block) = begin(tokens, diagnostics);
    items(&mut cursor, &mut block, diagnostics, |cursor, block, _| {
        if family::begins(cursor) {
            let help = "write the new variables by hand, as in `s[i]dot = c[i]*v[i]; c[i]dot = -s[i]*v[i];` for sine and \
                        cosine, or the equations of some sites one by one";
            let message =
                "a family of equations is not lifted: a lift is made for a fixed number of variables";
            return error(Kind::Syntax, cursor.here(), message, help);
        }
        block::parse_item(cursor, block)
    });
    refuse_functions_in_claims(&block, diagnostics);
    block
}

/// Reports claims that use a constant that is not rational, because claims must be rational.
fn refuse_functions_in_claims(block: &Block<FormulaSyntax>, diagnostics: &mut Diagnostics) {
    let mut functions: Vec<&str> = Vec::new();
    for constant in &block.constants {
        let Some(value) = &constant.value else { continue };
        let mut is_rational = false;
        if let Some(value) = value.rational() {
            is_rational = true;
            value.visit_names(&mut |named, _| {
                is_rational &= !functions.iter().any(|name| named == Reference::Name(name));
            });
        }
        if !is_rational {
            functions.push(&constant.name.text);
        }
    }
    for claim in &block.claims {
        let conditions = claim.conditions.iter().flat_map(|one| [&one.left, &one.right]);
        let values = claim.body.iter().flat_map(ClaimBody::expressions);
        for value in values.chain(conditions) {
            value.visit_names(&mut |named, span| {
                let Some(name) = functions.iter().find(|name| named == Reference::Name(name)) else { return };
                let message = format!("`{name}` holds a function, and claims are rational");
                let help = "write the new variable of the lift for it, such as `cos_x`";
                diagnostics.report(Kind::NotAPolynomial, span, message, help);
            });
        }
    }
}

fn begin<'a, X>(tokens: &'a [Token], diagnostics: &mut Diagnostics) -> (Cursor<'a>, Block<X>) {
    let (mut cursor, mut block) = (Cursor::new(tokens), Block::default());
    block.header = header::parse_header(&mut cursor, &mut block.lift, diagnostics);
    cursor.is_lifted = block.lift.is_some();
    (cursor, block)
}

fn items<X>(
    cursor: &mut Cursor<'_>,
    block: &mut Block<X>,
    diagnostics: &mut Diagnostics,
    item: impl Fn(&mut Cursor<'_>, &mut Block<X>, &mut Diagnostics) -> Parsed<()>,
) {
    while !cursor.is_at_end() {
        let start = cursor.position();
        if let Err(diagnostic) = item(cursor, block, diagnostics) {
            diagnostics.push(diagnostic);
            cursor.skip_item(start);
        }
    }
}
