//! What a command hands back, how it is printed, and rows of columns.

use std::io::{self, ErrorKind, Write};

use kahan_algebra::diagnostics::brief;
use kahan_algebra::render::folded;
use kahan_study::csv_line;
use serde::Serialize;
use serde_json::json;

use super::layout::terminal_width;

/// The result of a command that was understood.
#[derive(Debug)]
pub(crate) struct Answer {
    /// For standard output.
    pub(crate) text: String,
    /// Whether a terminal may break its lines at spaces.
    pub(crate) breaks: bool,
    /// A failed check or a pole, for standard error.
    pub(crate) complaint: Option<String>,
    /// The exit status.
    pub(crate) status: u8,
}

/// Bad usage or input: one paragraph for standard error; the exit status is 2.
#[derive(Debug)]
pub(crate) struct Refusal(String);

impl Answer {
    /// Plain text; a terminal breaks long lines at spaces.
    pub(crate) fn text(text: String) -> Self {
        Answer { text, breaks: true, complaint: None, status: 0 }
    }

    /// Nothing to print: another program has said what there is to say, and ended with this status.
    pub(crate) fn silent(status: u8) -> Self {
        Answer { status, ..Answer::verbatim(String::new()) }
    }

    /// A text of another language, in which a line break may mean something.
    pub(crate) fn verbatim(text: String) -> Self {
        Answer { breaks: false, ..Answer::text(text) }
    }

    /// One JSON object.
    pub(crate) fn json(object: &impl Serialize) -> Self {
        Answer::verbatim(format!("{:#}\n", json!(object)))
    }

    /// What was found, as one JSON object where that is asked for, or else as this text.
    pub(crate) fn of<F: Serialize>(found: &F, as_json: bool, text: impl FnOnce(&F) -> String) -> Self {
        if as_json { Answer::json(found) } else { Answer::text(text(found)) }
    }

    /// With a complaint, if there is one; then the exit status is 1.
    pub(crate) fn but(self, complaint: Option<String>) -> Self {
        let status = u8::from(complaint.is_some());
        Answer { complaint, status, ..self }
    }
}

impl Refusal {
    /// What is wrong and what to write instead, without `error:`.
    pub(crate) fn new(message: impl AsRef<str>) -> Self {
        Refusal(paragraph(message.as_ref()))
    }

    /// What it says, without `error:`.
    pub(crate) fn message(&self) -> &str {
        self.0.trim_start_matches("error: ").trim_end()
    }

    /// Reports that begin with `error:` and end with a line break already.
    pub(crate) fn reports(reports: String) -> Self {
        Refusal(reports)
    }
}

/// A message for standard error.
fn paragraph(message: &str) -> String {
    format!("error: {}\n", brief(message))
}

/// Says on standard error what does not hinder the command.
pub(crate) fn warn(note: &str) {
    // Where standard error is closed there is nobody left to tell.
    let _ = writeln!(io::stderr(), "note: {note}");
}

/// Prints a result and chooses the exit status. A reader that has gone away (`kahan | head`) is no
/// error.
pub(crate) fn finish(result: Result<Answer, Refusal>) -> u8 {
    let (text, complaint, status) = match result {
        Ok(Answer { text, breaks, complaint, status }) => {
            let width = terminal_width().filter(|_| breaks);
            let text = width.map_or_else(|| text.clone(), |width| folded(&text, width));
            (text, complaint.map_or_else(String::new, |complaint| paragraph(&complaint)), status)
        }
        Err(Refusal(reports)) => (String::new(), reports, 2),
    };
    let written = io::stdout().write_all(text.as_bytes()).and_then(|()| io::stdout().flush());
    // Where standard error is closed there is nobody left to tell.
    let _ = io::stderr().write_all(complaint.as_bytes());
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let _ = writeln!(io::stderr(), "error: cannot write the answer: {error}");
            1
        }
        _ => status,
    }
}

/// These in their order, with something between two of them.
pub(crate) fn joined<T: ToString>(items: impl IntoIterator<Item = T>, between: &str) -> String {
    let words: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    words.join(between)
}

/// Rows of cells without commas as CSV.
pub(crate) fn csv(rows: &[Vec<String>]) -> String {
    let mut text = String::new();
    rows.iter().for_each(|row| csv_line(&mut text, row));
    text
}
