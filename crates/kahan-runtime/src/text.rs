//! A text with a field, in the language of `kahan!` or as people write equations, as a checked
//! system; what is wrong with it becomes [`Diagnostics`].

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

/// A field in a text. Clones share the text and its equations, once they are read.
#[derive(Clone, Debug)]
pub struct FieldText {
    shared: Arc<Shared>,
}

#[derive(Debug)]
struct Shared {
    /// Written when it is first asked for, where the field is made of a system.
    text: OnceLock<String>,
    /// Where in the text the block stands; `None` where the field is made of a system.
    body: Option<Range<usize>>,
    /// What the text is called in reports.
    origin: String,
    said: OnceLock<Said>,
    unproved: OnceLock<Checked>,
}

/// Everything that a text says besides its equations.
#[derive(Debug)]
struct Said {
    /// The block in the language of `kahan!`, where the text is in none.
    canonical: Option<String>,
    /// Without its tokens.
    reading: Reading,
}

/// Two are equal if text, place and name are.
impl PartialEq for FieldText {
    fn eq(&self, other: &Self) -> bool {
        let of = |of: &FieldText| of.shared.body.clone();
        (self.whole(), of(self), &self.shared.origin) == (other.whole(), of(other), &other.shared.origin)
    }
}

impl FieldText {
    /// All of a text; `origin` is what it is called in reports, such as the name of its file.
    #[must_use]
    pub fn new(text: String, origin: String) -> Self {
        let all = 0..text.len();
        Self::part(text, all, origin)
    }

    /// A part of a text.
    ///
    /// # Panics
    /// If `body` does not lie in the text, or cuts a character.
    #[must_use]
    pub fn part(text: String, mut body: Range<usize>, origin: String) -> Self {
        // A mark of the byte order, as some editors put it in front.
        body.start += if text[body.clone()].starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let (said, unproved) = (OnceLock::new(), OnceLock::new());
        let (text, body) = (OnceLock::from(text), Some(body));
        FieldText { shared: Arc::new(Shared { text, body, origin, said, unproved }) }
    }

    /// A field without a text, whose claims are taken as they are: its text is written when it is
    /// first asked for. `origin` is what the text is called in reports.
    #[must_use]
    pub fn of_system(system: System, origin: String) -> Self {
        let said = Said { canonical: None, reading: Reading::default() };
        let (said, unproved) = (OnceLock::from(said), OnceLock::from(Checked::System(system)));
        let text = OnceLock::new();
        FieldText { shared: Arc::new(Shared { text, body: None, origin, said, unproved }) }
    }

    /// Whether the field is made of a system, and not of a text.
    fn is_made(&self) -> bool {
        self.shared.body.is_none()
    }

    /// The text in which the block stands.
    fn whole(&self) -> &str {
        self.shared.text.get_or_init(|| match self.unproved() {
            Checked::System(system) => equation_lines(&system.field).collect::<Vec<_>>().join("\n"),
            _ => unreachable!("a text was given"),
        })
    }

    /// The tokens of the block. They take several times the memory of the text, so nobody keeps
    /// them.
    fn tokens(&self) -> Vec<Token> {
        lenient::read(self.given()).lexed.tokens
    }

    /// Where each token stands in the text.
    fn ranges(&self) -> Vec<Range<usize>> {
        let before = self.shared.body.as_ref().map_or(0, |body| body.start);
        let ranges = lenient::read(self.given()).lexed.ranges;
        ranges.into_iter().map(|range| range.start + before..range.end + before).collect()
    }

    /// The block, its claims read but not proved. It is read once.
    fn unproved(&self) -> &Checked {
        self.shared.unproved.get_or_init(|| read_unproved_text(self.given()))
    }

    fn said(&self) -> &Said {
        self.shared.said.get_or_init(|| {
            let reading = lenient::read(self.given());
            let canonical = (!reading.is_canonical).then(|| reading.canonical());
            Said { canonical, reading: Reading { lexed: Lexed::default(), ..reading } }
        })
    }

    /// The system, with its claims proved as the macro does it.
    ///
    /// # Errors
    /// The mistakes of the text.
    pub fn system(&self) -> Result<System, Diagnostics> {
        if self.is_made() { self.unproved_system() } else { self.accept(read(&self.tokens()).system()) }
    }

    /// The family, with its claims proved for every number of sites; `None` where the block has
    /// plain equations.
    ///
    /// # Errors
    /// The mistakes of the text.
    pub fn family(&self) -> Result<Option<Family>, Diagnostics> {
        if self.is_made() { Ok(None) } else { self.accept(read(&self.tokens()).family()) }
    }

    /// The system, its claims read but not proved.
    ///
    /// # Errors
    /// The mistakes of the text.
    pub fn unproved_system(&self) -> Result<System, Diagnostics> {
        self.accept(self.unproved().clone().system())
    }

    /// Returns what a reader makes of the tokens of the block.
    ///
    /// # Errors
    /// The reader's mistakes, at their places in the text.
    pub fn read_by<T>(
        &self,
        reader: impl FnOnce(&[Token]) -> Result<T, Vec<Diagnostic>>,
    ) -> Result<T, Diagnostics> {
        self.accept(reader(&self.tokens()))
    }

    /// Proves the claims of a system that was read of this text, as the macro does it.
    ///
    /// # Errors
    /// The claims that do not hold.
    pub fn prove(&self, system: &System) -> Result<(), Diagnostics> {
        if system.claims.is_empty() || self.is_made() {
            return Ok(());
        }
        let mut mistakes = kahan_algebra::diagnostics::Diagnostics::default();
        check_claims(system, self.seed(), &mut mistakes);
        let mistakes = mistakes.finish();
        self.accept(if mistakes.is_empty() { Ok(()) } else { Err(mistakes) })
    }

    /// The names that are parameters because nothing declares them: the free names of a block
    /// without a header. Mistakes of the text do not matter here.
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

    /// The text of the field, as it was given.
    #[must_use]
    pub fn given(&self) -> &str {
        self.shared.body.clone().map_or(self.whole(), |body| &self.whole()[body])
    }

    /// The field in the language of `kahan!`: the text as it was given, where it is in that
    /// language.
    #[must_use]
    pub fn text(&self) -> &str {
        self.said().canonical.as_deref().unwrap_or_else(|| self.given())
    }

    /// The values that the text gives to parameters: `par a=1`, `a = 1`.
    #[must_use]
    pub fn parameters(&self) -> &[(String, Rational)] {
        &self.said().reading.parameters
    }

    /// The first values that the text gives to states: `init x=1`, `x(0) = 1`.
    #[must_use]
    pub fn start(&self) -> &[(String, Rational)] {
        &self.said().reading.start
    }

    /// Notes on what was read in a way that its writer should know of.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.said().reading.notes
    }

    /// The seed of the macro's proof.
    #[must_use]
    pub fn seed(&self) -> [u8; 32] {
        kahan_algebra::seed(&self.tokens())
    }

    fn accept<T>(&self, read: Result<T, Vec<Diagnostic>>) -> Result<T, Diagnostics> {
        read.map_err(|mistakes| Diagnostics::new(mistakes, self.whole(), &self.ranges(), &self.shared.origin))
    }
}
