//! Finds the calls of `kahan!` in a Rust or Markdown text: their ranges and names.
//!
//! Uses the lexer of rustc, because `proc-macro2` and `syn` reject Markdown and unclosed brackets.

#[cfg(test)]
mod tests;

use std::ops::Range;

use rustc_lexer::{FrontmatterAllowed, TokenKind, tokenize};

const MACRO: &str = "kahan";

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct RustBlock {
    pub(super) range: Range<usize>,
    /// The line on which the call of `kahan!` begins, counted from 1.
    pub(super) line: usize,
    /// The name of the block's struct, or of the variable to which the block is bound.
    pub(super) name: Option<String>,
}

struct Piece<'a> {
    kind: TokenKind,
    text: &'a str,
    range: Range<usize>,
}

pub(super) fn blocks(text: &str) -> Vec<RustBlock> {
    // If the macro's name does not occur, the text need not be split into tokens.
    if !text.contains(MACRO) {
        return Vec::new();
    }
    let pieces = pieces(text);
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(rest) = pieces.get(at..)
        && let [macro_name, bang, bracket, inside @ ..] = rest
    {
        let is_call = macro_name.text == MACRO && bang.kind == TokenKind::Bang && opens(bracket.kind);
        if !is_call {
            at += 1;
            continue;
        }
        let length = length_inside(inside);
        let end = inside.get(length).map_or(text.len(), |bracket| bracket.range.start);
        let bound = match &pieces[..at] {
            [.., variable, sign] if sign.kind == TokenKind::Eq => Some(variable.text.to_owned()),
            _ => None,
        };
        found.push(RustBlock {
            range: bracket.range.end..end,
            line: text[..macro_name.range.start].matches('\n').count() + 1,
            name: struct_name(&inside[..length]).or(bound),
        });
        at += 3 + length;
    }
    found
}

fn pieces(text: &str) -> Vec<Piece<'_>> {
    let mut end = 0;
    let pieces = tokenize(text, FrontmatterAllowed::No).map(|token| {
        let range = end..end + token.len as usize;
        end = range.end;
        Piece { kind: token.kind, text: &text[range.clone()], range }
    });
    let is_blank = |kind| {
        use TokenKind::{BlockComment, LineComment, Whitespace};
        matches!(kind, Whitespace | LineComment { .. } | BlockComment { .. })
    };
    pieces.filter(|piece| !is_blank(piece.kind)).collect()
}

fn opens(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::OpenBrace | TokenKind::OpenParen | TokenKind::OpenBracket)
}

fn closes(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::CloseBrace | TokenKind::CloseParen | TokenKind::CloseBracket)
}

/// Returns the number of tokens before the closing bracket, or of all tokens if no bracket closes.
fn length_inside(pieces: &[Piece<'_>]) -> usize {
    let mut depth = 1;
    let is_last = |piece: &Piece<'_>| {
        depth += i64::from(opens(piece.kind)) - i64::from(closes(piece.kind));
        depth == 0
    };
    pieces.iter().position(is_last).unwrap_or(pieces.len())
}

fn struct_name(block: &[Piece<'_>]) -> Option<String> {
    let named = block.windows(2).find(|pair| pair[0].text == "struct")?;
    (named[1].kind == TokenKind::Ident).then(|| named[1].text.to_owned())
}
