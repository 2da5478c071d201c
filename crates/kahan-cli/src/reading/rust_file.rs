//! The blocks of `kahan!` in a Rust file: where each begins and ends, and what it is called.
//!
//! Of Rust only as much is understood as tells a macro call from a comment, a string or a
//! character.

use std::ops::Range;

use kahan_algebra::lexer::lex;
use kahan_algebra::token::TokenKind;

/// One call of the macro.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct RustBlock {
    /// What stands between its brackets.
    pub(super) range: Range<usize>,
    /// The line of its `kahan!`, the first being 1.
    pub(super) line: usize,
    /// The name of its struct, or of the variable that holds it.
    pub(super) name: Option<String>,
}

/// The blocks of a file, in order; none where it is no Rust file, or has none.
pub(super) fn blocks(text: &str) -> Vec<RustBlock> {
    let mut found = Vec::new();
    // The last two pieces before the macro: `field` and `=` in `let field = kahan! { … }`.
    let mut before = ["", ""];
    let mut at = 0;
    while let Some(piece) = piece(text, at) {
        let word = &text[piece.clone()];
        at = piece.end;
        if is_blank(word) {
            continue;
        }
        if word == "kahan"
            && let Some(start) = opening(text, at)
        {
            let range = start..closing(text, start);
            let line = text[..piece.start].matches('\n').count() + 1;
            let bound = (before[1] == "=").then(|| before[0].to_owned());
            let name = struct_name(&text[range.clone()]).or(bound);
            at = range.end;
            found.push(RustBlock { range, line, name });
        }
        before = [before[1], word];
    }
    found
}

/// The next piece of Rust: a comment, a string, a character, a word, or a single sign.
fn piece(text: &str, at: usize) -> Option<Range<usize>> {
    let rest = &text[at..];
    let first = rest.chars().next()?;
    let length = if rest.starts_with("//") {
        rest.find('\n').unwrap_or(rest.len())
    } else if rest.starts_with("/*") {
        comment(rest)
    } else if first == '"' {
        string(rest)
    } else if first == '\'' {
        character(rest)
    } else if is_of_word(first) {
        let word = rest.find(|c| !is_of_word(c)).unwrap_or(rest.len());
        raw_string(&rest[..word], &rest[word..]).map_or(word, |string| word + string)
    } else {
        first.len_utf8()
    };
    Some(at..at + length)
}

fn is_blank(piece: &str) -> bool {
    piece.trim().is_empty() || piece.starts_with("//") || piece.starts_with("/*")
}

fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The length of a comment, which may have others inside.
fn comment(rest: &str) -> usize {
    let mut depth = 0_usize;
    let mut at = 0;
    while at < rest.len() {
        if rest[at..].starts_with("/*") {
            depth += 1;
            at += 2;
        } else if rest[at..].starts_with("*/") {
            depth -= 1;
            at += 2;
            if depth == 0 {
                return at;
            }
        } else {
            at += rest[at..].chars().next().map_or(1, char::len_utf8);
        }
    }
    rest.len()
}

/// The length of a string with its quotes; a backslash hides what follows it.
fn string(rest: &str) -> usize {
    let mut is_hidden = false;
    for (at, c) in rest.char_indices().skip(1) {
        match c {
            '"' if !is_hidden => return at + 1,
            '\\' => is_hidden = !is_hidden,
            _ => is_hidden = false,
        }
    }
    rest.len()
}

/// The length of what follows the `r` of a raw string; `None` where none follows.
fn raw_string(prefix: &str, rest: &str) -> Option<usize> {
    if !matches!(prefix, "r" | "br" | "cr") {
        return None;
    }
    let signs = rest.len() - rest.trim_start_matches('#').len();
    let inside = rest[signs..].strip_prefix('"')?;
    let end = format!("\"{}", "#".repeat(signs));
    Some(inside.find(&end).map_or(rest.len(), |at| signs + 1 + at + end.len()))
}

/// The length of a character with its quotes, or of the quote of a lifetime.
fn character(rest: &str) -> usize {
    let mut inside = rest[1..].char_indices();
    match inside.next() {
        Some((_, '\\')) => rest[3.min(rest.len())..].find('\'').map_or(rest.len(), |at| at + 4),
        Some((_, c)) if rest[1 + c.len_utf8()..].starts_with('\'') => c.len_utf8() + 2,
        _ => 1,
    }
}

/// Where the text of a macro call begins, if `! {` or its like follows the name.
fn opening(text: &str, mut at: usize) -> Option<usize> {
    let mut wanted = ["!"].iter();
    while let Some(piece) = piece(text, at) {
        let word = &text[piece.clone()];
        at = piece.end;
        match (is_blank(word), wanted.next()) {
            (true, sign) => wanted = if sign.is_some() { ["!"].iter() } else { [].iter() },
            (false, Some(sign)) if word == *sign => {}
            (false, None) if matches!(word, "{" | "(" | "[") => return Some(at),
            _ => return None,
        }
    }
    None
}

/// Where the bracket that is open at `start` closes; the end of the text where it does not.
fn closing(text: &str, start: usize) -> usize {
    let mut depth = 0_usize;
    let mut at = start;
    while let Some(piece) = piece(text, at) {
        match &text[piece.clone()] {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" if depth == 0 => return piece.start,
            "}" | ")" | "]" => depth -= 1,
            _ => {}
        }
        at = piece.end;
    }
    text.len()
}

/// The name behind the first `struct` of a block.
fn struct_name(block: &str) -> Option<String> {
    let tokens = lex(block).tokens;
    let named = tokens.windows(2).find(|pair| pair[0].text == "struct")?;
    (named[1].kind == TokenKind::Identifier).then(|| named[1].text.clone())
}

#[cfg(test)]
mod tests {
    use super::blocks;

    const FILE: &str = r##"//! kahan! { not this }
use kahan_core::prelude::*;
/* nor /* this */ kahan! { xdot = x; } */
const TEXT: &str = "kahan! { no }"; const RAW: &str = r#"kahan! { " }"#;
const QUOTE: char = '"'; const HIDDEN: char = '\''; fn f<'a>(x: &'a str) {}
kahan! {
    /// A doc comment with a }.
    pub struct First { a }
    xdot = a*x;
}
mod inner {
    kahan_core::kahan!(struct Second; xdot = x; bracket P { {x,y} = 1; });
    fn g() { let mut field = kahan![ydot = y;]; kahan ! { zdot = z; }; kahan(); }
}
"##;

    #[test]
    fn every_call_is_found_and_nothing_else() {
        let found = blocks(FILE);
        let names: Vec<Option<&str>> = found.iter().map(|block| block.name.as_deref()).collect();
        assert_eq!(names, [Some("First"), Some("Second"), Some("field"), None]);
        assert_eq!(found.iter().map(|block| block.line).collect::<Vec<_>>(), [6, 12, 13, 13]);
        let inside: Vec<&str> = found.iter().map(|block| FILE[block.range.clone()].trim()).collect();
        assert!(inside[0].starts_with("/// A doc") && inside[0].ends_with("xdot = a*x;"), "{}", inside[0]);
        assert!(inside[1].ends_with("{x,y} = 1; }"), "{}", inside[1]);
        assert_eq!(inside[2..], ["ydot = y;", "zdot = z;"]);
    }

    #[test]
    fn what_is_not_closed_ends_with_the_file() {
        for text in ["kahan! { xdot = x;", "kahan!{", "a /* b", "\"c", "r#\"d", "'", "'\\", "kahan", "kahan!"]
        {
            assert!(blocks(text).iter().all(|block| block.range.end == text.len()), "{text}");
        }
        assert!(blocks("xdot = y; ydot = -x;").is_empty());
    }
}
