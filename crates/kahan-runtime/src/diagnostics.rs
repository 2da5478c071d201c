//! The mistakes in a text, as an error.

use core::fmt;
use std::ops::Range;

use kahan_algebra::diagnostics::Diagnostic;
use kahan_algebra::render::{place, report};

/// The mistakes in a text in the language of `kahan!`, with the macro's spans and messages.
///
/// The `Display` form has a paragraph for each of the first eight mistakes: the message, the source
/// line with a caret, and the correction to write.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostics {
    mistakes: Vec<Diagnostic>,
    places: Vec<[usize; 2]>,
    /// The paragraphs of the first mistakes, without their help texts.
    reports: Vec<String>,
}

impl Diagnostics {
    pub(crate) fn new(mistakes: Vec<Diagnostic>, text: &str, ranges: &[Range<usize>], origin: &str) -> Self {
        const MAX_SHOWN: usize = 8;
        let bare = |mistake: &Diagnostic| Diagnostic { help: String::new(), ..mistake.clone() };
        let shown = mistakes.iter().take(MAX_SHOWN);
        let reports = shown.map(|mistake| report(&bare(mistake), text, ranges, origin));
        let places = mistakes.iter().map(|mistake| place(mistake, text, ranges));
        Diagnostics { places: places.collect(), reports: reports.collect(), mistakes }
    }

    /// Returns the mistakes, in the order of the text.
    #[must_use]
    pub fn mistakes(&self) -> &[Diagnostic] {
        &self.mistakes
    }

    /// Returns the line and column where each mistake begins, counted from 1.
    #[must_use]
    pub fn places(&self) -> &[[usize; 2]] {
        &self.places
    }

    /// Removes the help texts, for a caller that offers a correction of its own.
    #[must_use]
    pub fn without_help(mut self) -> Self {
        self.mistakes.iter_mut().for_each(|mistake| mistake.help.clear());
        self
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (report, mistake) in self.reports.iter().zip(&self.mistakes) {
            f.write_str(report)?;
            if !mistake.help.is_empty() {
                writeln!(f, "help: {}", mistake.help)?;
            }
        }
        match self.mistakes.len() - self.reports.len() {
            0 => Ok(()),
            more => writeln!(f, "error: {more} more mistakes are not shown"),
        }
    }
}

impl core::error::Error for Diagnostics {}
