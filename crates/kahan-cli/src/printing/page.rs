//! What pages of formulas are put together from: sections of plain text, displays of LaTeX,
//! matrices.

use kahan_algebra::render::{
    MatrixText, Notation, claim_statement, condition_statement, condition_text, lines,
};
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::{Claim, System};
use kahan_latex::Latex;
use kahan_latex::breaking::{self, PAGE_WIDTH};

use super::layout::{matrix_within, screen_width};

/// Text that grows downwards.
#[derive(Default)]
pub(crate) struct Page {
    pub(crate) text: String,
}

impl Page {
    pub(crate) fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// Sentences, as many lines as the screen takes.
    pub(crate) fn prose(&mut self, text: &str) {
        for line in lines(text, screen_width()) {
            self.line(&line);
        }
    }

    pub(crate) fn section(&mut self, title: &str, lines: Vec<String>) {
        self.line("");
        self.line(title);
        for line in lines {
            self.line(&format!("{:INDENT$}{line}", ""));
        }
    }

    pub(crate) fn display(&mut self, formula: &str) {
        self.line(&format!("\\[\n{formula}\n\\]"));
    }

    /// A claim in LaTeX, with a comment that says which, and perhaps where it is from.
    pub(crate) fn claim(&mut self, system: &System, claim: &Claim, source: Option<&str>) {
        let name = &claim.name.text;
        let source = source.map_or_else(String::new, |source| format!(": {source}"));
        let condition = condition_text(system, claim);
        let when = if condition.is_empty() { String::new() } else { format!(", when {condition}") };
        self.line(&format!("% {} {name}{when}{source}", claim.kind.keyword()));
        let index = match claim.kind {
            ClaimKind::Bracket => format!("_{{{}}}", Latex.name(name)),
            _ => String::new(),
        };
        let statements = claim_statement(claim, &Latex).into_iter();
        let mut rows: Vec<String> = statements
            .map(|(left, right)| breaking::equation(&format!("{left}{index}"), &right, PAGE_WIDTH))
            .collect();
        if !claim.is_unconditional() {
            rows.push(format!("&\\text{{where }} {}", condition_statement(system, claim, &Latex)));
        }
        self.display(&aligned(rows));
    }
}

/// A column as a matrix.
pub(crate) fn singletons(entries: &[String]) -> MatrixText {
    entries.iter().map(|entry| vec![entry.clone()]).collect()
}

/// The columns by which a section is indented.
const INDENT: usize = 2;

/// A matrix as lines of a section.
pub(crate) fn matrix(rows: &[Vec<String>], left: char, right: char) -> Vec<String> {
    matrix_within(rows, left, right, screen_width().saturating_sub(INDENT))
}

/// Sentences as lines of a section.
pub(crate) fn paragraph(text: &str) -> Vec<String> {
    lines(text, screen_width().saturating_sub(INDENT))
}

/// A column in brackets, a line a row.
pub(crate) fn column(entries: &[String]) -> Vec<String> {
    matrix(&singletons(entries), '[', ']')
}

/// Equations in LaTeX, one below the other.
pub(crate) fn aligned(lines: Vec<String>) -> String {
    format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", lines.join(" \\\\\n"))
}
