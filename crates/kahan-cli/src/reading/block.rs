//! A text with a block in it, as a checked system; everything that is wrong with it becomes a
//! [`Refusal`].

use std::ops::Range;

use kahan_algebra::family::Family;
use kahan_runtime::{Diagnostics, FieldText};
use kahan_study::Subject;
use kahan_systems::entry::Entry;
use kahan_systems::lattices;

use super::rust_file::blocks;
use crate::printing::Refusal;

/// A text with a block in it.
#[derive(Debug)]
pub(crate) struct Block {
    /// The catalog's entry, where it is one.
    pub(crate) entry: Option<&'static Entry>,
    text: FieldText,
    /// Whether it stands in a call of the macro.
    is_rust: bool,
}

impl Block {
    /// A block of the catalog.
    pub(crate) fn of_catalog(entry: &'static Entry) -> Self {
        Block::new(Some(entry), entry.text().to_owned(), entry.command.to_owned())
    }

    /// A family of the catalog.
    pub(crate) fn of_family(family: &lattices::Entry) -> Self {
        Block::new(None, family.text.to_owned(), family.command.to_owned())
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
        let is_rust = body != (0..text.len());
        Block { entry: None, text: FieldText::part(text, body, origin), is_rust }
    }

    /// The block as what a question is about.
    pub(super) fn subject(&self) -> Subject {
        Subject::block(self.text.clone())
    }

    /// The names that the block takes as parameters because nothing declares them. A block of Rust
    /// has none: such names are variables of the program.
    pub(super) fn undeclared(&self) -> Vec<String> {
        if self.is_rust { Vec::new() } else { self.text.undeclared() }
    }

    /// The family that the block has; `option` is what a block of equations is refused for.
    pub(crate) fn family(&self, option: &str) -> Result<Family, Refusal> {
        self.text.family().map_err(refusal)?.ok_or_else(|| {
            Refusal::new(format!(
                "{option} is for a family, `for i in periodic {{ x[i]dot = …; }}`, and this field has its equations written out"
            ))
        })
    }

    /// The text of the block, as it was given.
    pub(crate) fn text(&self) -> &str {
        self.text.text()
    }
}

fn refusal(diagnostics: Diagnostics) -> Refusal {
    Refusal::reports(diagnostics.to_string())
}
