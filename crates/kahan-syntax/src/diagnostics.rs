//! Mistakes as data: what kind, where, what is wrong in the user's terms, what to write instead.
//!
//! The macro turns a [`Diagnostic`] into `compile_error!` at its tokens, the command into a
//! paragraph with a caret: the same text from the same place. [`Diagnostics`] collects them and
//! cannot be forgotten.

use std::fmt;

use crate::table::sorted_by_key;
use crate::token::Span;

/// What rule was broken; for tests and for tools, never shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// Text or tokens that do not follow the grammar.
    Syntax,
    /// A literal that is no exact decimal number.
    Number,
    /// An exponent that is not allowed where it stands.
    Exponent,
    /// A header that is not `struct Name;` or `struct Name { a, b }`.
    Header,
    /// An identifier that nothing defines.
    UnknownName,
    /// A name used twice, reserved, or otherwise not to be had.
    Name,
    /// A parameter that nothing uses.
    UnusedParameter,
    /// A term of degree three or more in the states.
    Degree,
    /// A divisor that depends on a state.
    StateDivisor,
    /// A divisor that is zero.
    ZeroDivisor,
    /// A function call, a path or an index.
    NotAPolynomial,
    /// A limit on size.
    TooLarge,
    /// A block without equations.
    Empty,
    /// A claim that says nothing, is malformed, or cannot be evaluated.
    Claim,
    /// A claim that is false.
    FalseClaim,
}

/// One mistake.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The rule that was broken.
    pub kind: Kind,
    /// The tokens to change.
    pub span: Span,
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub help: String,
}

impl Diagnostic {
    /// A mistake of `kind` at `span`: what is wrong, and what to write instead, each made
    /// [`brief`].
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

/// A message as it is, unless what it quotes is too long for one: then a word of more than 80
/// characters keeps its beginning and its end, and so does the whole if it still has more than 700.
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

/// A text of at most `longest` characters as it is, of another the first and the last few.
fn without_middle(text: &str, longest: usize, first: usize, last: usize) -> String {
    // So many bytes are that many characters at most.
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

/// The most mistakes that are kept; more than these are told after the first are corrected.
const MOST_MISTAKES: usize = 200;

/// The mistakes found so far. Dropping a collector without [`Diagnostics::finish`] is a bug and
/// panics.
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
    /// Adds a mistake, unless the same message stands at the same place, or the list is full.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        if let Some(list) = &mut self.list
            && list.len() < MOST_MISTAKES
            && !list.contains(&diagnostic)
        {
            list.push(diagnostic);
        }
    }

    /// Adds a mistake from its parts.
    pub fn report(&mut self, kind: Kind, span: Span, message: impl Into<String>, help: impl Into<String>) {
        self.push(Diagnostic::new(kind, span, message, help));
    }

    /// Whether nothing was found so far.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.list.as_ref().is_none_or(Vec::is_empty)
    }

    /// Returns whether the list is full, so that no more mistakes are kept.
    #[must_use]
    pub fn is_full(&self) -> bool {
        self.len() >= MOST_MISTAKES
    }

    /// How many mistakes were found so far.
    #[must_use]
    pub fn len(&self) -> usize {
        self.list.as_ref().map_or(0, Vec::len)
    }

    /// Hands the mistakes over, in the order of their places.
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
