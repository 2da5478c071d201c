//! A text in the language of `kahan!`, as a checked system; what is wrong with it becomes
//! [`Diagnostics`].

use std::ops::Range;

use kahan_algebra::family::Family;
use kahan_algebra::lexer::{Lexed, lex};
use kahan_algebra::system::System;
use kahan_algebra::{check, diagnostics, parse, read};

use crate::diagnostics::Diagnostics;

/// A block of the language in a text.
#[derive(Clone, Debug)]
pub struct FieldText {
    text: String,
    /// Where in the text the block stands.
    body: Range<usize>,
    lexed: Lexed,
    /// What the text is called in reports.
    origin: String,
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
        let mut lexed = lex(&text[body.clone()]);
        for range in &mut lexed.ranges {
            *range = range.start + body.start..range.end + body.start;
        }
        FieldText { text, body, lexed, origin }
    }

    /// The system, with its claims proved as the macro does it.
    ///
    /// # Errors
    /// The mistakes of the text.
    pub fn system(&self) -> Result<System, Diagnostics> {
        let mut reading = read(&self.lexed.tokens);
        if let Some(family) = &reading.family
            && reading.diagnostics.is_empty()
        {
            reading.diagnostics.push(check::number_of_sites_wanted(family.span));
        }
        self.accept(reading.system, reading.diagnostics)
    }

    /// The family, with its claims proved for every number of sites; `None` where the block has
    /// plain equations.
    ///
    /// # Errors
    /// The mistakes of the text.
    pub fn family(&self) -> Result<Option<Family>, Diagnostics> {
        let reading = read(&self.lexed.tokens);
        self.accept(reading.family, reading.diagnostics)
    }

    /// The system, its claims read but not proved.
    ///
    /// # Errors
    /// The mistakes of the text.
    pub fn unproved_system(&self) -> Result<System, Diagnostics> {
        let mut found = diagnostics::Diagnostics::default();
        let block = parse::parse(&self.lexed.tokens, &mut found);
        let system = check::check(block, &mut found);
        self.accept(system, found.finish())
    }

    /// The names that are parameters because nothing declares them: the free names of a block
    /// without a header. Mistakes of the text do not matter here.
    #[must_use]
    pub fn undeclared(&self) -> Vec<String> {
        let mut ignored = diagnostics::Diagnostics::default();
        let block = parse::parse(&self.lexed.tokens, &mut ignored);
        let names = if block.header.is_some() {
            Vec::new()
        } else if let Some(family) = check::check_family(&block, &mut ignored) {
            [family.parameters, family.site_parameters].concat()
        } else {
            check::check(block, &mut ignored).field.symbols.parameters
        };
        let _: Vec<diagnostics::Diagnostic> = ignored.finish();
        names
    }

    /// The text of the block, as it was given.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text[self.body.clone()]
    }

    /// The seed of the macro's proof.
    #[must_use]
    pub fn seed(&self) -> [u8; 32] {
        kahan_algebra::seed(&self.lexed.tokens)
    }

    fn accept<T>(&self, read: T, mistakes: Vec<diagnostics::Diagnostic>) -> Result<T, Diagnostics> {
        if mistakes.is_empty() {
            return Ok(read);
        }
        Err(Diagnostics::new(mistakes, &self.text, &self.lexed.ranges, &self.origin))
    }
}
