//! Tokens: the one input of the parser, made from text ([`crate::lexer`]) or from a macro's tokens
//! (`tokens.rs` of `kahan-emit`).
//!
//! A token knows its text and whether the next one touches it, not where it stands: places are
//! indices into the token list ([`Span`]), and whoever made the list keeps the map from index to
//! byte range or compiler span. So one parser and one set of messages serve both.

use std::borrow::Cow;

/// A run of tokens, from `first` to `last` inclusive, as indices into the token list of its block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// Index of the first token.
    pub first: usize,
    /// Index of the last token.
    pub last: usize,
}

impl Span {
    /// The span of the single token `index`.
    #[must_use]
    pub fn token(index: usize) -> Self {
        Span { first: index, last: index }
    }

    /// The smallest span that covers `self` and `other`.
    #[must_use]
    pub fn to(self, other: Span) -> Self {
        Span { first: self.first.min(other.first), last: self.last.max(other.last) }
    }
}

/// What a token is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// An identifier or keyword; a raw identifier without its `r#`.
    Identifier,
    /// A literal of any sort, its suffix included; only numbers have a meaning here.
    Literal,
    /// One punctuation character.
    Punctuation(char),
    /// `(`, `[` or `{`.
    Open(char),
    /// `)`, `]` or `}`.
    Close(char),
    /// Something that no token of the language begins with; the lexer says what to write instead.
    Unreadable(Box<Unreadable>),
}

impl TokenKind {
    /// A mistake in place of a token.
    pub(crate) fn unreadable(message: impl Into<String>, help: impl Into<String>) -> Self {
        TokenKind::Unreadable(Box::new(Unreadable { message: message.into(), help: help.into() }))
    }

    /// The kind of a token of the language that begins with this character.
    pub(crate) fn beginning_with(c: char) -> Self {
        match c {
            '(' | '[' | '{' => TokenKind::Open(c),
            ')' | ']' | '}' => TokenKind::Close(c),
            '0'..='9' => TokenKind::Literal,
            _ if c == '_' || c.is_alphabetic() => TokenKind::Identifier,
            _ => TokenKind::Punctuation(c),
        }
    }
}

/// The message for text that is no token of the language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The mistake.
    pub message: String,
    /// Advice: the text to write in its place.
    pub help: String,
}

/// One token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Its text as written.
    pub text: Cow<'static, str>,
    /// Whether the next token follows without white space (`**` is two touching stars).
    pub touches_next: bool,
    /// Lines of documentation before it, `/// …` as written; for rustc they are attributes.
    pub docs: Box<[String]>,
}
