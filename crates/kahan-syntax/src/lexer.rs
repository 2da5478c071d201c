//! Splits texts into tokens. Comments, raw identifiers and numbers follow the rules of Rust.
//!
//! The lexer also accepts text that rustc rejects, such as `.5`, `**`, `x²`, `−` and `# comments`.
//! An unknown sign, such as the prime in `x'`, becomes a token with an explanation.

use std::borrow::Cow;
use std::ops::Range;

use crate::rational::numeral::Numeral;
use crate::token::{Token, TokenKind};

/// The tokens of a text, with their byte ranges.
#[derive(Clone, Debug, Default)]
pub struct Lexed {
    /// The tokens.
    pub tokens: Vec<Token>,
    /// The byte range of each token in the text.
    pub ranges: Vec<Range<usize>>,
    /// Whether the text has comments or line continuations that Rust does not have, such as `# …`.
    pub is_of_others: bool,
}

/// Splits `text` into tokens. An unknown character becomes [`TokenKind::Unreadable`].
#[must_use]
pub fn lex(text: &str) -> Lexed {
    let mut lexer = Lexer { text, at: 0, docs: Vec::new(), out: Lexed::default() };
    while lexer.next_token() {}
    lexer.out
}

const PUNCTUATION: &str = "+-*/^=;,.:<>!?&|%#@~$()[]{}";

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    docs: Vec<String>,
    out: Lexed,
}

impl Lexer<'_> {
    fn peek(&self, ahead: usize) -> Option<char> {
        self.text[self.at..].chars().nth(ahead)
    }

    /// Counts the bytes from `from` up to the first character that fails `keep`.
    fn run(&self, from: usize, keep: impl Fn(char) -> bool) -> usize {
        self.text[from..].chars().take_while(|&c| keep(c)).map(char::len_utf8).sum()
    }

    fn push(&mut self, kind: TokenKind, length: usize) {
        let text = &self.text[self.at..self.at + length];
        let text = text.strip_prefix("r#").filter(|_| kind == TokenKind::Identifier).unwrap_or(text);
        let text_of_sign = match kind {
            // Half of a field's tokens are punctuation. Borrowed texts save an allocation for each.
            TokenKind::Punctuation(c) | TokenKind::Open(c) | TokenKind::Close(c) => {
                PUNCTUATION.find(c).map(|place| Cow::Borrowed(&PUNCTUATION[place..=place]))
            }
            _ => None,
        };
        self.put(kind, text_of_sign.unwrap_or_else(|| Cow::Owned(text.to_owned())), length);
        self.at += length;
    }

    /// Adds a token for the next `length` bytes. The position does not change.
    fn put(&mut self, kind: TokenKind, text: Cow<'static, str>, length: usize) {
        let range = self.at..self.at + length;
        if let (Some(previous), Some(last)) = (self.out.tokens.last_mut(), self.out.ranges.last()) {
            previous.touches_next = last.end >= range.start;
        }
        let docs = std::mem::take(&mut self.docs).into();
        self.out.tokens.push(Token { kind, text, touches_next: false, docs });
        self.out.ranges.push(range);
    }

    /// Reads one token, comment or white-space character; returns `false` at the end of the text.
    fn next_token(&mut self) -> bool {
        let Some(c) = self.peek(0) else { return false };
        if c.is_whitespace() {
            self.at += c.len_utf8();
        } else if self.text[self.at..].starts_with("//") {
            let line = &self.text[self.at..][..self.run(self.at, |c| c != '\n')];
            self.at += line.len();
            if line.starts_with("///") && !line.starts_with("////") {
                self.docs.push(line.trim_end().to_owned());
            }
        } else if c == '"' && self.begins_line()
            || c == '#' && !["#[", "#!["].iter().any(|sign| self.text[self.at..].starts_with(sign))
        {
            self.out.is_of_others = true;
            self.at += self.run(self.at, |c| c != '\n');
        } else if c == '\\'
            && self.text[self.at + 1..].trim_start_matches([' ', '\t', '\r']).starts_with('\n')
        {
            self.out.is_of_others = true;
            self.at += 1;
        } else if self.text[self.at..].starts_with("/*") {
            self.block_comment();
        } else if c.is_ascii_digit() {
            let length = self.number_length();
            self.push(TokenKind::Literal, length);
        } else if c == '.' && self.begins_fraction() {
            let length = 1 + Numeral::length_in(&self.text[self.at + 1..]);
            let number = format!("0{}", &self.text[self.at..self.at + length]);
            self.put(TokenKind::Literal, Cow::Owned(number), length);
            self.at += length;
        } else if starts_identifier(c) {
            let raw = self.text[self.at..].starts_with("r#") && self.peek(2).is_some_and(starts_identifier);
            let prefix = if raw { 2 } else { 0 };
            let length = prefix + self.run(self.at + prefix, continues_identifier);
            self.push(TokenKind::Identifier, length);
        } else if c == '"' {
            let length = self.string_length();
            self.push(TokenKind::Literal, length);
        } else if let Some((signs, length)) = self.signs(c) {
            for (place, sign) in signs.char_indices() {
                self.put(TokenKind::beginning_with(sign), Cow::Borrowed(&signs[place..=place]), length);
            }
            self.at += length;
        } else if PUNCTUATION.contains(c) {
            self.push(TokenKind::beginning_with(c), 1);
        } else {
            let length = self.run(self.at, |c| primes(c).is_some()).max(c.len_utf8());
            let (what, help) = match primes(c) {
                Some(_) => (
                    "a prime marks a derivative on left-hand sides",
                    "put in what the derivative is equal to",
                ),
                None => ("this character has no meaning in a field", "remove it"),
            };
            let sign = primes(c).map_or_else(|| c.escape_debug().to_string(), |_| c.to_string());
            self.push(TokenKind::unreadable(format!("`{sign}`: {what}"), help), length);
        }
        true
    }

    fn begins_line(&self) -> bool {
        let before = self.text[..self.at].trim_end_matches([' ', '\t']);
        before.is_empty() || before.ends_with('\n')
    }

    fn begins_fraction(&self) -> bool {
        let before = self.text[..self.at].chars().next_back();
        self.peek(1).is_some_and(|c| c.is_ascii_digit())
            && !before.is_some_and(|c| c == '.' || c.is_ascii_digit() || continues_identifier(c))
    }

    /// Returns the ASCII text for a sign such as `−` or `²`, and the number of bytes read.
    fn signs(&self, c: char) -> Option<(&'static str, usize)> {
        let signs = match c {
            '*' if self.peek(1) == Some('*') => return Some(("^", 2)),
            '²' => "^2",
            '³' => "^3",
            '−' | '–' | '—' => "-",
            '·' | '×' | '∗' | '⋅' => "*",
            '÷' | '∕' => "/",
            '½' => "(1/2)",
            _ => return None,
        };
        Some((signs, c.len_utf8()))
    }

    /// Skips a comment `/* … */`, which may be nested; reports an unclosed comment at its start.
    fn block_comment(&mut self) {
        let mut depth = 0;
        let mut end = self.at;
        while end < self.text.len() {
            let rest = &self.text[end..];
            if rest.starts_with("/*") {
                depth += 1;
                end += 2;
            } else if rest.starts_with("*/") {
                depth -= 1;
                end += 2;
                if depth == 0 {
                    self.at = end;
                    return;
                }
            } else {
                end += rest.chars().next().map_or(1, char::len_utf8);
            }
        }
        self.push(TokenKind::unreadable("this comment is not closed", "write `*/` where it ends"), 2);
        self.at = self.text.len();
    }

    /// Returns the length of a number with the letters that follow, as in `1.5e-3` and `2x`.
    fn number_length(&self) -> usize {
        let length = Numeral::length_in(&self.text[self.at..]);
        length + self.run(self.at + length, continues_identifier)
    }

    fn string_length(&self) -> usize {
        let mut escaped = false;
        for (offset, c) in self.text[self.at..].char_indices().skip(1) {
            match c {
                '"' if !escaped => return offset + 1,
                '\\' => escaped = !escaped,
                _ => escaped = false,
            }
        }
        self.text.len() - self.at
    }
}

pub(crate) fn starts_identifier(c: char) -> bool {
    c == '_' || c.is_alphabetic()
}

/// Returns whether `c` may continue a name. This includes combining marks, such as the dot of `ẋ`.
fn continues_identifier(c: char) -> bool {
    starts_identifier(c) || c.is_ascii_digit() || ('\u{300}'..='\u{36f}').contains(&c)
}

/// Returns the order of the derivative that a prime sign denotes.
pub(crate) fn primes(c: char) -> Option<usize> {
    match c {
        '\'' | '’' | '′' => Some(1),
        '″' => Some(2),
        _ => None,
    }
}
