//! Mistakes of the user as data: a kind, a position, a message and a help text.
//!
//! The macro turns a [`Diagnostic`] into `compile_error!` at its tokens. The command prints the
//! mistake with a caret under the text.

use std::fmt;

use crate::table::sorted_by_key;
use crate::token::Span;

/// The kind of a mistake, by which tests and tools distinguish mistakes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// Text or tokens that do not follow the grammar.
    Syntax,
    /// A number that is not an exact decimal, such as `0x1F` or `1f32`.
    Number,
    /// An exponent that is no integer literal, or one of the two exponents in `a^b^c`.
    Exponent,
    /// A header that is neither `struct Name;` nor `struct Name { a, b }`.
    Header,
    /// An identifier without a definition.
    UnknownName,
    /// A name that is defined twice, reserved, or not allowed for another reason.
    Name,
    /// An unused parameter.
    UnusedParameter,
    /// A term of degree 3 or more in the states.
    Degree,
    /// A divisor that depends on a state.
    StateDivisor,
    /// A divisor that is zero.
    ZeroDivisor,
    /// A function call, a path or an index.
    NotAPolynomial,
    /// A size that exceeds a limit of the language.
    TooLarge,
    /// A block without equations.
    Empty,
    /// A claim that is trivial or malformed, or that cannot be evaluated.
    Claim,
    /// A claim that is false.
    FalseClaim,
}

/// A mistake of the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The broken rule.
    pub kind: Kind,
    /// The tokens that should be changed.
    pub span: Span,
    /// A description of the mistake, in one sentence.
    pub message: String,
    /// The text that should be written instead, which may be empty.
    pub help: String,
}

impl Diagnostic {
    /// Creates a mistake at `span`. Long messages and help texts are shortened by [`brief`].
    #[must_use]
    pub fn new(kind: Kind, span: Span, message: impl Into<String>, help: impl Into<String>) -> Self {
        Diagnostic { kind, span, message: brief(&message.into()), help: brief(&help.into()) }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        if !self.help.is_empty() {
            write!(f, "\nhelp: {}", self.help)?;
        }
        Ok(())
    }
}

/// Shortens a message that quotes long words.
///
/// Of a word with more than 80 characters, the first 46 and the last 16 are kept. Of a message that
/// then still has more than 700 characters, the first 440 and the last 240 are kept.
///
/// ```
/// let name = "x".repeat(1_000_000);
/// let message = kahan_syntax::diagnostics::brief(&format!("there is no `{name}` here"));
/// assert!(message.starts_with("there is no `xxx") && message.ends_with("xxx` here"));
/// assert!(message.len() < 100);
/// ```
#[must_use]
pub fn brief(message: &str) -> String {
    let words = message.split_inclusive(char::is_whitespace);
    let short: String = words.map(|word| without_middle(word, 80, 46, 16)).collect();
    without_middle(&short, 700, 440, 240)
}

fn without_middle(text: &str, longest: usize, first: usize, last: usize) -> String {
    if text.len() <= longest {
        return text.to_owned();
    }
    let count = text.chars().count();
    if count <= longest {
        return text.to_owned();
    }
    let head: String = text.chars().take(first).collect();
    let tail: String = text.chars().skip(count - last).collect();
    format!("{head}…{tail}")
}

const MOST_MISTAKES: usize = 200;

/// The mistakes collected so far.
///
/// # Panics
/// If the list is dropped without a call of [`Diagnostics::finish`].
#[derive(Debug)]
pub struct Diagnostics {
    list: Option<Vec<Diagnostic>>,
}

impl Default for Diagnostics {
    fn default() -> Self {
        Diagnostics { list: Some(Vec::new()) }
    }
}

impl Diagnostics {
    /// Adds a mistake, unless the list is full or contains an equal mistake.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        if let Some(list) = &mut self.list
            && list.len() < MOST_MISTAKES
            && !list.contains(&diagnostic)
        {
            list.push(diagnostic);
        }
    }

    /// Adds a mistake that is given by its fields, like [`Diagnostics::push`].
    pub fn report(&mut self, kind: Kind, span: Span, message: impl Into<String>, help: impl Into<String>) {
        self.push(Diagnostic::new(kind, span, message, help));
    }

    /// Returns whether the list is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.list.as_ref().is_none_or(Vec::is_empty)
    }

    /// Returns whether the list is full. Further mistakes are then dropped.
    #[must_use]
    pub fn is_full(&self) -> bool {
        self.len() >= MOST_MISTAKES
    }

    /// Returns the number of mistakes found so far.
    #[must_use]
    pub fn len(&self) -> usize {
        self.list.as_ref().map_or(0, Vec::len)
    }

    /// Returns the mistakes, sorted by position.
    #[must_use]
    pub fn finish(mut self) -> Vec<Diagnostic> {
        sorted_by_key(self.list.take().unwrap_or_default(), |diagnostic| diagnostic.span)
    }
}

impl Drop for Diagnostics {
    fn drop(&mut self) {
        assert!(self.list.is_none() || std::thread::panicking(), "diagnostics were dropped unread");
    }
}
