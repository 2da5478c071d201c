//! What is wrong with a plan: each mistake with its line, and what to write instead.

use std::cell::RefCell;
use std::ops::Range;

/// Mistakes while they are found.
pub(super) struct Collector<'a> {
    text: &'a str,
    /// Lines, from 1 on, and what is wrong there.
    found: RefCell<Vec<(usize, String)>>,
}

impl<'a> Collector<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { text, found: RefCell::default() }
    }

    /// Notes what is wrong at a place of the text.
    pub(super) fn note(&self, at: &Range<usize>, message: impl Into<String>) {
        let before = &self.text.as_bytes()[..at.start.min(self.text.len())];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        self.found.borrow_mut().push((line, message.into()));
    }

    pub(super) fn is_empty(&self) -> bool {
        self.found.borrow().is_empty()
    }

    /// The source of a value, as it stands in the text.
    pub(super) fn source(&self, at: Range<usize>) -> &'a str {
        self.text.get(at).unwrap_or_default()
    }

    /// What was read if nothing is wrong with it, or all mistakes in the order of their lines.
    pub(super) fn finish<T>(self, origin: &str, read: Option<T>) -> Result<T, String> {
        let mut found = self.found.into_inner();
        if found.is_empty() {
            return Ok(read.expect("where nothing is missing nothing was noted"));
        }
        found.sort_by_key(|(line, _)| *line);
        let lines = found.iter().map(|(line, message)| format!("{origin}:{line}: {message}"));
        Err(lines.collect::<Vec<_>>().join("\n"))
    }
}
