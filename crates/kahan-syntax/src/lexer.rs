//! Text to tokens, with Rust's rules where Rust has any (comments, raw identifiers, `1.` is a
//! number, `.5` is not).
//!
//! The macro never comes here: rustc has lexed its input already. What stops rustc's lexer (`x' =
//! …`, `x²`, `3eps`) becomes a token that carries its explanation, so that the command reports it
//! like any other mistake.

use std::borrow::Cow;
use std::cell::OnceCell;
use std::collections::HashSet;
use std::ops::Range;

use crate::rational::numeral::Numeral;
use crate::spelling::derivative;
use crate::token::{Token, TokenKind, Unreadable};

/// The tokens of a text and the byte range of each.
#[derive(Clone, Debug, Default)]
pub struct Lexed {
    /// The tokens.
    pub tokens: Vec<Token>,
    /// The byte range of each token in the text.
    pub ranges: Vec<Range<usize>>,
}

/// Splits `text` into tokens. Never fails: what is no token becomes [`TokenKind::Unreadable`].
#[must_use]
pub fn lex(text: &str) -> Lexed {
    let mut lexer = Lexer {
        text,
        at: 0,
        docs: Vec::new(),
        is_right: false,
        words: OnceCell::new(),
        out: Lexed::default(),
    };
    while lexer.next_token() {}
    lexer.out
}

/// The punctuation of the language and of Rust, and brackets.
const SIGNS: &str = "+-*/^=;,.:<>!?&|%#@~$()[]{}";

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    /// Lines of documentation before the next token.
    docs: Vec<String>,
    /// Whether the next token stands behind the `=` of its item.
    is_right: bool,
    /// All words of the text, for messages.
    words: OnceCell<HashSet<&'a str>>,
    out: Lexed,
}

impl Lexer<'_> {
    fn peek(&self, ahead: usize) -> Option<char> {
        self.text[self.at..].chars().nth(ahead)
    }

    /// The byte length of the longest prefix whose characters satisfy `keep`.
    fn run(&self, from: usize, keep: impl Fn(char) -> bool) -> usize {
        self.text[from..].chars().take_while(|&c| keep(c)).map(char::len_utf8).sum()
    }

    fn push(&mut self, kind: TokenKind, length: usize) {
        let range = self.at..self.at + length;
        let text = &self.text[range.clone()];
        let text = text.strip_prefix("r#").filter(|_| kind == TokenKind::Identifier).unwrap_or(text);
        if let (Some(previous), Some(last)) = (self.out.tokens.last_mut(), self.out.ranges.last()) {
            previous.touches_next = last.end == range.start;
        }
        self.is_right = match kind {
            TokenKind::Punctuation('=') => true,
            TokenKind::Punctuation(';') | TokenKind::Open('{') => false,
            _ => self.is_right,
        };
        let docs = std::mem::take(&mut self.docs).into();
        let text_of_sign = match kind {
            // Half of the tokens of a field, none of which allocates.
            TokenKind::Punctuation(c) | TokenKind::Open(c) | TokenKind::Close(c) => {
                SIGNS.find(c).map(|place| Cow::Borrowed(&SIGNS[place..=place]))
            }
            _ => None,
        };
        let text = text_of_sign.unwrap_or_else(|| Cow::Owned(text.to_owned()));
        self.out.tokens.push(Token { kind, text, touches_next: false, docs });
        self.out.ranges.push(range);
        self.at += length;
    }

    /// Reads one token or one stretch of white space; `false` at the end.
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
        } else if self.text[self.at..].starts_with("/*") {
            self.block_comment();
        } else if c == '#' && !matches!(self.peek(1), Some('[' | '!')) {
            let (message, help) =
                ("`#` begins no comment here".to_owned(), "write `//` before a comment".to_owned());
            self.push(
                TokenKind::Unreadable(Box::new(Unreadable { message, help })),
                self.run(self.at, |c| c != '\n'),
            );
        } else if c.is_ascii_digit() {
            let length = self.number_length();
            self.push(TokenKind::Literal, length);
        } else if starts_identifier(c) {
            let raw = self.text[self.at..].starts_with("r#") && self.peek(2).is_some_and(starts_identifier);
            let prefix = if raw { 2 } else { 0 };
            let length = prefix + self.run(self.at + prefix, continues_identifier);
            self.push(TokenKind::Identifier, length);
        } else if c == '"' {
            let length = self.string_length();
            self.push(TokenKind::Literal, length);
        } else if matches!(c, '(' | '[' | '{') {
            self.push(TokenKind::Open(c), 1);
        } else if matches!(c, ')' | ']' | '}') {
            self.push(TokenKind::Close(c), 1);
        } else if SIGNS.contains(c) {
            self.push(TokenKind::Punctuation(c), 1);
        } else if let Some(order) = primes(c) {
            let length = self.run(self.at, |c| primes(c).is_some());
            let order = order.max(self.text[self.at..][..length].chars().filter_map(primes).sum());
            let (message, help) = self.explain_prime(c, order);
            self.push(TokenKind::Unreadable(Box::new(Unreadable { message, help })), length);
        } else {
            let (message, help) = explain_unreadable(c);
            self.push(TokenKind::Unreadable(Box::new(Unreadable { message, help })), c.len_utf8());
        }
        true
    }

    /// What a prime here means elsewhere: a derivative of the name that it touches.
    fn explain_prime(&self, prime: char, order: usize) -> (String, String) {
        let touches = self.out.ranges.last().is_some_and(|last| last.end == self.at);
        let before = self.out.tokens.last().filter(|token| touches && token.kind == TokenKind::Identifier);
        let state = before.map_or("x", |token| &*token.text);
        let words = || self.text.split(|c| !continues_identifier(c)).collect();
        let help = if self.is_right {
            format!("a right-hand side has no derivatives: put in what `{state}dot` is equal to")
        } else {
            derivative(state, order, |name| self.words.get_or_init(words).contains(name))
        };
        (format!("`{prime}`: a prime marks no derivative here"), help)
    }

    /// Skips `/* … */`, which nests in Rust; one that is not closed is a mistake at its beginning.
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
        let (message, help) =
            ("this comment is not closed".to_owned(), "write `*/` where it ends".to_owned());
        self.push(TokenKind::Unreadable(Box::new(Unreadable { message, help })), 2);
        self.at = self.text.len();
    }

    /// A number and whatever letters touch it: `1`, `1.`, `1.5e-3`, `0x1F`, `2x`, `3eps`.
    fn number_length(&self) -> usize {
        let text = &self.text[self.at..];
        let length = text.len() - Numeral::scan(text).rest.len();
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

fn starts_identifier(c: char) -> bool {
    c == '_' || c.is_alphabetic()
}

/// Marks above letters, such as Newton's dot, belong to the name, as in Rust.
fn continues_identifier(c: char) -> bool {
    starts_identifier(c) || c.is_ascii_digit() || ('\u{300}'..='\u{36f}').contains(&c)
}

/// How many derivatives a mark behind a name means elsewhere.
fn primes(c: char) -> Option<usize> {
    match c {
        '\'' | '’' | '′' => Some(1),
        '″' => Some(2),
        _ => None,
    }
}

fn explain_unreadable(c: char) -> (String, String) {
    let (what, help) = match c {
        '²' => ("superscripts are not read", "write `^2`"),
        '³' => ("superscripts are not read", "write `^3`"),
        '−' | '–' | '—' => ("this is not the minus sign of the keyboard", "write `-`"),
        '·' | '×' | '∗' | '⋅' => ("this is not the multiplication sign of the language", "write `*`"),
        '÷' | '∕' => ("this is not the division sign of the language", "write `/`"),
        '½' => ("fractions are written out", "write `1/2`"),
        _ => ("this character has no meaning in a field", "remove it"),
    };
    (format!("`{}`: {what}", c.escape_debug()), help.to_owned())
}
