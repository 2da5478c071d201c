//! A text that contains a field, which is read as a checked system.
//!
//! In: a text in the language of `kahan!` or another common notation for equations. Out: a
//! [`System`] or [`Family`] with its claims, or [`Diagnostics`].

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use kahan_algebra::check::{Broken, Checked};
use kahan_algebra::diagnostics::Diagnostic;
use kahan_algebra::family::Family;
use kahan_algebra::lenient::{self, Reading};
use kahan_algebra::lexer::Lexed;
use kahan_algebra::prove::check_claims;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::equation_lines;
use kahan_algebra::system::System;
use kahan_algebra::token::Token;
use kahan_algebra::{read, read_unproved_text};

use crate::diagnostics::Diagnostics;

/// A field in a text. The text is read once; clones share the text and its equations.
#[derive(Clone, Debug)]
pub struct FieldText {
    shared: Arc<SharedText>,
}

#[derive(Debug)]
struct SharedText {
    /// The text. For a field made from a system, the text is written at first use.
    text: OnceLock<String>,
    /// The range of the field in the text; `None` for a field made from a system.
    body: Option<Range<usize>>,
    origin: String,
    said: OnceLock<ReadText>,
    unproved: OnceLock<Checked>,
}

#[derive(Debug)]
struct ReadText {
    /// The block in the language of `kahan!`, if the text has another notation.
    canonical: Option<String>,
    /// The parsed block; its tokens are not stored.
    reading: Reading,
}

impl PartialEq for FieldText {
    fn eq(&self, other: &Self) -> bool {
        let of = |of: &FieldText| of.shared.body.clone();
        (self.whole(), of(self), &self.shared.origin) == (other.whole(), of(other), &other.shared.origin)
    }
}

impl FieldText {
    /// Wraps a whole text; `origin` names the text in reports, for example by a file name.
    #[must_use]
    pub fn new(text: String, origin: String) -> Self {
        let all = 0..text.len();
        Self::part(text, all, origin)
    }

    /// Wraps a range of a text; `origin` names the text in reports.
    ///
    /// # Panics
    /// If `body` is not within the text, or splits a character.
    #[must_use]
    pub fn part(text: String, mut body: Range<usize>, origin: String) -> Self {
        body.start += if text[body.clone()].starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let (said, unproved) = (OnceLock::new(), OnceLock::new());
        let (text, body) = (OnceLock::from(text), Some(body));
        FieldText { shared: Arc::new(SharedText { text, body, origin, said, unproved }) }
    }

    /// Wraps a system, whose claims are not proved again. The text of the system is written at
    /// first use; `origin` names the text in reports.
    #[must_use]
    pub fn of_system(system: System, origin: String) -> Self {
        let said = ReadText { canonical: None, reading: Reading::default() };
        let (said, unproved) = (OnceLock::from(said), OnceLock::from(Checked::System(system)));
        let text = OnceLock::new();
        FieldText { shared: Arc::new(SharedText { text, body: None, origin, said, unproved }) }
    }

    fn is_generated(&self) -> bool {
        self.shared.body.is_none()
    }

    fn whole(&self) -> &str {
        self.shared.text.get_or_init(|| match self.unproved() {
            Checked::System(system) => equation_lines(&system.field).collect::<Vec<_>>().join("\n"),
            _ => unreachable!("a text was given"),
        })
    }

    /// Returns the tokens of the block, which are not stored because they take much memory.
    fn tokens(&self) -> Vec<Token> {
        lenient::read(self.given()).lexed.tokens
    }

    fn ranges(&self) -> Vec<Range<usize>> {
        let before = self.shared.body.as_ref().map_or(0, |body| body.start);
        let ranges = lenient::read(self.given()).lexed.ranges;
        ranges.into_iter().map(|range| range.start + before..range.end + before).collect()
    }

    fn unproved(&self) -> &Checked {
        self.shared.unproved.get_or_init(|| read_unproved_text(self.given()))
    }

    fn read_text(&self) -> &ReadText {
        self.shared.said.get_or_init(|| {
            let reading = lenient::read(self.given());
            let canonical = (!reading.is_canonical).then(|| reading.canonical());
            ReadText { canonical, reading: Reading { lexed: Lexed::default(), ..reading } }
        })
    }

    /// Returns the system, after proving its claims as the macro does.
    ///
    /// # Errors
    /// [`Diagnostics`] with the mistakes of the text.
    pub fn system(&self) -> Result<System, Diagnostics> {
        if self.is_generated() { self.unproved_system() } else { self.accept(read(&self.tokens()).system()) }
    }

    /// Returns the family, after proving its claims for every number of sites; `None` for a system.
    ///
    /// # Errors
    /// [`Diagnostics`] with the mistakes of the text.
    pub fn family(&self) -> Result<Option<Family>, Diagnostics> {
        if self.is_generated() { Ok(None) } else { self.accept(read(&self.tokens()).family()) }
    }

    /// Returns the system with its claims unproved.
    ///
    /// # Errors
    /// [`Diagnostics`] with the mistakes of the text.
    pub fn unproved_system(&self) -> Result<System, Diagnostics> {
        self.accept(self.unproved().clone().system())
    }

    /// Passes the tokens of the block to a reader, and returns its result.
    ///
    /// # Errors
    /// [`Diagnostics`] with the mistakes that the reader found, at their positions in the text.
    pub fn read_by<T>(
        &self,
        reader: impl FnOnce(&[Token]) -> Result<T, Vec<Diagnostic>>,
    ) -> Result<T, Diagnostics> {
        self.accept(reader(&self.tokens()))
    }

    /// Proves the claims of a system read from this text, as the macro does.
    ///
    /// # Errors
    /// [`Diagnostics`] with the claims that do not hold.
    pub fn prove(&self, system: &System) -> Result<(), Diagnostics> {
        if system.claims.is_empty() || self.is_generated() {
            return Ok(());
        }
        let mut mistakes = kahan_algebra::diagnostics::Diagnostics::default();
        check_claims(system, self.seed(), &mut mistakes);
        let mistakes = mistakes.finish();
        self.accept(if mistakes.is_empty() { Ok(()) } else { Err(mistakes) })
    }

    /// Returns the undeclared names in a block without a header; they become parameters.
    #[must_use]
    pub fn undeclared(&self) -> Vec<String> {
        match self.unproved() {
            Checked::System(System { header: None, field, .. }) => field.symbols.parameters.clone(),
            Checked::Family(Family { header: None, parameters, site_parameters, .. }) => {
                [&parameters[..], site_parameters].concat()
            }
            Checked::Broken(Broken { stand_in, .. }) if stand_in.header.is_none() => {
                [&stand_in.symbols.parameters[..], &stand_in.site_parameters].concat()
            }
            _ => Vec::new(),
        }
    }

    /// Returns the text of the field as given.
    #[must_use]
    pub fn given(&self) -> &str {
        self.shared.body.clone().map_or(self.whole(), |body| &self.whole()[body])
    }

    /// Returns the field in the language of `kahan!`; a text in this language is returned as given.
    #[must_use]
    pub fn text(&self) -> &str {
        self.read_text().canonical.as_deref().unwrap_or_else(|| self.given())
    }

    /// Returns the values that the text gives to parameters: `par a=1`, `a = 1`.
    #[must_use]
    pub fn parameters(&self) -> &[(String, Rational)] {
        &self.read_text().reading.parameters
    }

    /// Returns the initial values that the text gives to states: `init x=1`, `x(0) = 1`.
    #[must_use]
    pub fn start(&self) -> &[(String, Rational)] {
        &self.read_text().reading.start
    }

    /// Returns notes on interpretations that the author may not expect.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.read_text().reading.notes
    }

    /// Returns the seed of the random choices in proofs of claims. The macro uses the same seed.
    #[must_use]
    pub fn seed(&self) -> [u8; 32] {
        kahan_algebra::seed(&self.tokens())
    }

    fn accept<T>(&self, read: Result<T, Vec<Diagnostic>>) -> Result<T, Diagnostics> {
        read.map_err(|mistakes| Diagnostics::new(mistakes, self.whole(), &self.ranges(), &self.shared.origin))
    }
}
