//! What `kahan show` writes is put together from: sections of plain text, displays of LaTeX, matrices.

use kahan_algebra::render::{MatrixText, lines};

use super::super::layout::{matrix_within, screen_width};

/// Text that grows downwards.
#[derive(Default)]
pub(super) struct Page {
    pub(super) text: String,
}

impl Page {
    pub(super) fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// Sentences, as many lines as the screen takes.
    pub(super) fn prose(&mut self, text: &str) {
        for line in lines(text, screen_width()) {
            self.line(&line);
        }
    }

    pub(super) fn section(&mut self, title: &str, lines: Vec<String>) {
        self.line("");
        self.line(title);
        for line in lines {
            self.line(&format!("{:INDENT$}{line}", ""));
        }
    }

    pub(super) fn display(&mut self, formula: &str) {
        self.line(&format!("\\[\n{formula}\n\\]"));
    }
}

/// A column as a matrix.
pub(super) fn singletons(entries: &[String]) -> MatrixText {
    entries.iter().map(|entry| vec![entry.clone()]).collect()
}

/// The columns by which a section is indented.
const INDENT: usize = 2;

/// A matrix as lines of a section.
pub(super) fn matrix(rows: &[Vec<String>], left: char, right: char) -> Vec<String> {
    matrix_within(rows, left, right, screen_width().saturating_sub(INDENT))
}

/// Sentences as lines of a section.
pub(super) fn paragraph(text: &str) -> Vec<String> {
    lines(text, screen_width().saturating_sub(INDENT))
}

/// A column in brackets, a line a row.
pub(super) fn column(entries: &[String]) -> Vec<String> {
    matrix(&singletons(entries), '[', ']')
}

/// Equations in LaTeX, one below the other.
pub(super) fn aligned(lines: Vec<String>) -> String {
    format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", lines.join(" \\\\\n"))
}
