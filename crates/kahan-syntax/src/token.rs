//! Tokens, the input of the parser.
//!
//! Tokens come from a text ([`crate::lexer`]) or from a macro (`tokens.rs` of `kahan-emit`).
//! Positions are indices into the list of tokens ([`Span`]), so that one parser serves both
//! sources.

use std::borrow::Cow;

/// A range of tokens from `first` to `last`, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// The index of the first token.
    pub first: usize,
    /// The index of the last token.
    pub last: usize,
}

impl Span {
    /// Returns the span of the single token with this index.
    #[must_use]
    pub fn token(index: usize) -> Self {
        Span { first: index, last: index }
    }

    /// Returns the smallest span that covers `self` and `other`.
    #[must_use]
    pub fn to(self, other: Span) -> Self {
        Span { first: self.first.min(other.first), last: self.last.max(other.last) }
    }
}

/// The kind of a token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// An identifier or a keyword.
    Identifier,
    /// A literal of any kind, with its suffix. The parser accepts only numbers.
    Literal,
    /// One punctuation character.
    Punctuation(char),
    /// An opening bracket `(`, `[` or `{`.
    Open(char),
    /// A closing bracket `)`, `]` or `}`.
    Close(char),
    /// Text that begins no token of the language, with a replacement to propose.
    Unreadable(Box<UnreadableText>),
}

impl TokenKind {
    pub(crate) fn unreadable(message: impl Into<String>, help: impl Into<String>) -> Self {
        TokenKind::Unreadable(Box::new(UnreadableText { message: message.into(), help: help.into() }))
    }

    /// Returns the kind of the token that begins with this character.
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

/// A mistake in text that begins no token of the language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnreadableText {
    /// A description of the mistake, in one sentence.
    pub message: String,
    /// The text that should be written instead.
    pub help: String,
}

/// A token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// The kind of the token.
    pub kind: TokenKind,
    /// The text of the token as written, without a leading `r#`.
    pub text: Cow<'static, str>,
    /// Whether the next token follows without white space, as between the two signs of `**`.
    pub touches_next: bool,
    /// The documentation lines `/// …` before the token in a text.
    pub docs: Box<[String]>,
}
