//! A text with a block in it, as a checked system; everything that is wrong with it becomes a
//! [`Refusal`].

use std::ops::Range;

use kahan_algebra::diagnostics::{Diagnostic, Diagnostics};
use kahan_algebra::lexer::{Lexed, lex};
use kahan_algebra::render::report;
use kahan_algebra::system::System;
use kahan_algebra::{check, parse, read};
use kahan_systems::entry::Entry;

use super::rust_file::blocks;
use crate::printing::Refusal;

/// A text with a block in it.
#[derive(Debug)]
pub(crate) struct Block {
    /// The catalog's entry, where it is one.
    pub(crate) entry: Option<&'static Entry>,
    text: String,
    /// Where in the text the block stands.
    body: Range<usize>,
    lexed: Lexed,
    /// What the text is called in reports.
    origin: String,
}

impl Block {
    /// A block of the catalog.
    pub(crate) fn of_catalog(entry: &'static Entry) -> Self {
        Block::new(Some(entry), entry.text().to_owned(), entry.command.to_owned())
    }

    /// A text from elsewhere; `origin` is what it is called in reports.
    pub(crate) fn of_text(text: String, origin: String) -> Self {
        Block::new(None, text, origin)
    }

    /// The text itself, or the one call of `kahan!` in it.
    fn new(entry: Option<&'static Entry>, text: String, origin: String) -> Self {
        let body = blocks(&text).into_iter().next().map_or(0..text.len(), |block| block.range);
        Block { entry, ..Block::within(text, body, origin) }
    }

    /// A part of a text.
    pub(super) fn within(text: String, mut body: Range<usize>, origin: String) -> Self {
        // A mark of the byte order, as some editors put it in front.
        body.start += if text[body.clone()].starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let mut lexed = lex(&text[body.clone()]);
        for range in &mut lexed.ranges {
            *range = range.start + body.start..range.end + body.start;
        }
        Block { entry: None, text, body, lexed, origin }
    }

    /// The system, with its claims proved as the macro does it.
    pub(crate) fn system(&self) -> Result<System, Refusal> {
        let reading = read(&self.lexed.tokens);
        self.accept(reading.system, &reading.diagnostics)
    }

    /// The system, its claims read but not proved.
    pub(crate) fn unproved_system(&self) -> Result<System, Refusal> {
        let mut diagnostics = Diagnostics::default();
        let block = parse::parse(&self.lexed.tokens, &mut diagnostics);
        let system = check::check(block, &mut diagnostics);
        self.accept(system, &diagnostics.finish())
    }

    /// The text of the block, as it was given.
    pub(crate) fn text(&self) -> &str {
        &self.text[self.body.clone()]
    }

    /// The seed of the macro's proof.
    pub(crate) fn seed(&self) -> u64 {
        kahan_algebra::seed(&self.lexed.tokens)
    }

    /// The name of the system in answers: the catalog's, or the header's, or `field`.
    pub(crate) fn name(&self, system: &System) -> String {
        self.entry.map_or_else(|| system.name().to_owned(), |entry| entry.command.to_owned())
    }

    fn accept(&self, system: System, diagnostics: &[Diagnostic]) -> Result<System, Refusal> {
        if diagnostics.is_empty() {
            return Ok(system);
        }
        /// Nobody reads more at once.
        const MOST: usize = 8;
        let shown = diagnostics.iter().take(MOST);
        let reports = shown.map(|one| report(one, &self.text, &self.lexed.ranges, &self.origin));
        let reports: String = reports.collect();
        Err(Refusal::reports(match diagnostics.len().saturating_sub(MOST) {
            0 => reports,
            more => format!("{reports}error: {more} more mistakes are not shown\n"),
        }))
    }
}
