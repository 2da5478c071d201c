//! Tokens to syntax: a recursive-descent parser of the language of `kahan!`.
//!
//! Never through Rust's own expression parser, whose `^` binds looser than `+`. A mistake ends its
//! item, not the block: the parser skips to the next `;` (or to the next line that begins an item)
//! and goes on, so that several mistakes are reported at once. Whatever the tokens, it returns a
//! block and never panics.
//!
//! The same expressions, with calls of functions, stand outside of blocks: [`parse_formula`] reads
//! one, [`parse_formulas`] a list with names.

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
use crate::syntax::{Block, InFormula};
use crate::token::{Span, Token};

use cursor::Cursor;
pub use formula::{parse_formula, parse_formulas};
pub(crate) use mistakes::{is_function, is_statement};
pub(crate) use number::product;

/// What a parsing function gives: its syntax, or the first mistake in it.
type Parsed<T> = Result<T, Diagnostic>;

fn error<T>(kind: Kind, span: Span, message: impl Into<String>, help: impl Into<String>) -> Parsed<T> {
    Err(Diagnostic::new(kind, span, message, help))
}

/// Reads a whole block.
#[must_use]
pub fn parse(tokens: &[Token], diagnostics: &mut Diagnostics) -> Block {
    block(tokens, diagnostics, |cursor, block, diagnostics| {
        if family::begins(cursor) {
            family::family(cursor, block, diagnostics)
        } else {
            block::parse_item(cursor, block)
        }
    })
}

/// Reads a block that is to be lifted: its equations may hold functions and any powers.
#[must_use]
pub fn parse_lifted(tokens: &[Token], diagnostics: &mut Diagnostics) -> Block<InFormula> {
    block(tokens, diagnostics, |cursor, block, _| block::parse_item(cursor, block))
}

fn block<X>(
    tokens: &[Token],
    diagnostics: &mut Diagnostics,
    item: impl Fn(&mut Cursor<'_>, &mut Block<X>, &mut Diagnostics) -> Parsed<()>,
) -> Block<X> {
    let mut cursor = Cursor::new(tokens);
    let mut block = Block { header: header::parse_header(&mut cursor, diagnostics), ..Block::default() };
    while !cursor.is_at_end() {
        let start = cursor.position();
        if let Err(diagnostic) = item(&mut cursor, &mut block, diagnostics) {
            diagnostics.push(diagnostic);
            cursor.skip_item(start);
        }
    }
    block
}
