//! Answers and refusals, and how these are printed.

use std::io::{self, ErrorKind, Write};

use kahan_algebra::diagnostics::brief;
use kahan_algebra::render::folded;
use kahan_study::csv_line;
use serde::Serialize;
use serde_json::json;

use super::layout::terminal_width;

/// The result of a command with valid arguments.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) text: String,
    /// Whether long lines are broken at spaces on a terminal.
    pub(crate) breaks: bool,
    /// A message for standard error about a failed check or a pole.
    pub(crate) complaint: Option<String>,
    pub(crate) status: u8,
}

/// A message about wrong usage or input: one paragraph for standard error, with exit status 2.
#[derive(Debug)]
pub(crate) struct UsageError(String);

impl Answer {
    /// Returns a plain text, whose long lines a terminal breaks at spaces.
    pub(crate) fn text(text: String) -> Self {
        Answer { text, breaks: true, complaint: None, status: 0 }
    }

    /// Returns an empty answer with this exit status, after a program has printed its answer.
    pub(crate) fn silent(status: u8) -> Self {
        Answer { status, ..Answer::verbatim(String::new()) }
    }

    /// Returns an answer whose line breaks must be kept.
    pub(crate) fn verbatim(text: String) -> Self {
        Answer { breaks: false, ..Answer::text(text) }
    }

    pub(crate) fn json(object: &impl Serialize) -> Self {
        Answer::verbatim(format!("{:#}\n", json!(object)))
    }

    /// Returns the JSON object of `found`, or its text.
    pub(crate) fn of<F: Serialize>(found: &F, as_json: bool, text: impl FnOnce(&F) -> String) -> Self {
        if as_json { Answer::json(found) } else { Answer::text(text(found)) }
    }

    /// Adds a complaint, if there is one. The exit status is then 1.
    pub(crate) fn with_complaint(self, complaint: Option<String>) -> Self {
        let status = u8::from(complaint.is_some());
        Answer { complaint, status, ..self }
    }
}

impl UsageError {
    /// Makes a refusal from a message, and writes `error:` before the message.
    pub(crate) fn new(message: impl AsRef<str>) -> Self {
        UsageError(paragraph(message.as_ref()))
    }

    pub(crate) fn message(&self) -> &str {
        self.0.trim_start_matches("error: ").trim_end()
    }

    /// Makes a refusal from reports that already begin with `error:` and end with a line break.
    pub(crate) fn reports(reports: String) -> Self {
        UsageError(reports)
    }
}

fn paragraph(message: &str) -> String {
    format!("error: {}\n", brief(message))
}

pub(crate) fn warn(note: &str) {
    let _ = writeln!(io::stderr(), "note: {note}");
}

/// Prints a result, and returns the exit status. A closed pipe is not an error.
pub(crate) fn finish(result: Result<Answer, UsageError>) -> u8 {
    let (text, complaint, status) = match result {
        Ok(Answer { text, breaks, complaint, status }) => {
            let width = terminal_width().filter(|_| breaks);
            let text = width.map_or_else(|| text.clone(), |width| folded(&text, width));
            (text, complaint.map_or_else(String::new, |complaint| paragraph(&complaint)), status)
        }
        Err(UsageError(reports)) => (String::new(), reports, 2),
    };
    let written = io::stdout().write_all(text.as_bytes()).and_then(|()| io::stdout().flush());
    let _ = io::stderr().write_all(complaint.as_bytes());
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let _ = writeln!(io::stderr(), "error: cannot write the answer: {error}");
            2
        }
        _ => status,
    }
}

pub(crate) fn joined<T: ToString>(items: impl IntoIterator<Item = T>, between: &str) -> String {
    let words: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    words.join(between)
}

/// Formats rows as CSV; cells contain no commas.
pub(crate) fn csv(rows: &[Vec<String>]) -> String {
    let mut text = String::new();
    rows.iter().for_each(|row| csv_line(&mut text, row));
    text
}
