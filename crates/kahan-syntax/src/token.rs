//! Tokens, the input of the parser.
//!
//! They come from text ([`crate::lexer`]) or from a macro (`tokens.rs` of `kahan-emit`). Positions
//! are indices into the token list ([`Span`]); the maker of the list maps them to byte ranges or
//! compiler spans. One parser and one set of messages therefore serve both.

use std::borrow::Cow;

/// A range of tokens, from `first` to `last` inclusive, as indices into a block's token list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// The index of the first token.
    pub first: usize,
    /// The index of the last token.
    pub last: usize,
}

impl Span {
    /// Returns the span of the single token `index`.
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
    /// An identifier or keyword.
    Identifier,
    /// A literal of any kind, with its suffix. The parser accepts only numbers.
    Literal,
    /// One punctuation character.
    Punctuation(char),
    /// `(`, `[` or `{`.
    Open(char),
    /// `)`, `]` or `}`.
    Close(char),
    /// Text that begins no token of the language, with a proposed replacement.
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

/// The mistake in text that begins no token of the language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnreadableText {
    /// The mistake, in one sentence.
    pub message: String,
    /// The text to write instead.
    pub help: String,
}

/// A token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// The kind.
    pub kind: TokenKind,
    /// The text as written, without a leading `r#`.
    pub text: Cow<'static, str>,
    /// Whether the next token follows without white space, as in `**`.
    pub touches_next: bool,
    /// Documentation lines before the token, `/// …`; from rustc they come as attributes.
    pub docs: Box<[String]>,
}
