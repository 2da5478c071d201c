//! A text with a block in it, as a checked system; everything that is wrong with it becomes a
//! [`Refusal`].

use std::ops::Range;

use kahan_algebra::system::System;
use kahan_runtime::{Diagnostics, FieldText};
use kahan_systems::entry::Entry;

use super::rust_file::blocks;
use crate::printing::Refusal;

/// A text with a block in it.
#[derive(Debug)]
pub(crate) struct Block {
    /// The catalog's entry, where it is one.
    pub(crate) entry: Option<&'static Entry>,
    text: FieldText,
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
    pub(super) fn within(text: String, body: Range<usize>, origin: String) -> Self {
        Block { entry: None, text: FieldText::part(text, body, origin) }
    }

    /// The system, with its claims proved as the macro does it.
    pub(crate) fn system(&self) -> Result<System, Refusal> {
        self.text.system().map_err(refusal)
    }

    /// The system, its claims read but not proved.
    pub(crate) fn unproved_system(&self) -> Result<System, Refusal> {
        self.text.unproved_system().map_err(refusal)
    }

    /// The text of the block, as it was given.
    pub(crate) fn text(&self) -> &str {
        self.text.text()
    }

    /// The seed of the macro's proof.
    pub(crate) fn seed(&self) -> u64 {
        self.text.seed()
    }

    /// The name of the system in answers: the catalog's, or the header's, or `field`.
    pub(crate) fn name(&self, system: &System) -> String {
        self.entry.map_or_else(|| system.name().to_owned(), |entry| entry.command.to_owned())
    }
}

fn refusal(diagnostics: Diagnostics) -> Refusal {
    Refusal::reports(diagnostics.to_string())
}
