//! Pages of formulas: sections of plain text, displayed formulas in LaTeX, and matrices.

use kahan_algebra::render::{MatrixText, Notation, lines};
use kahan_algebra::syntax::ClaimKind;
use kahan_latex::Latex;
use kahan_latex::breaking::{self, PAGE_WIDTH};
use kahan_study::ClaimShown;

use super::layout::{self, screen_width};

#[derive(Default)]
pub(crate) struct Page {
    pub(crate) text: String,
}

impl Page {
    pub(crate) fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// Appends sentences, broken to the width of the screen.
    pub(crate) fn prose(&mut self, text: &str) {
        for line in lines(text, screen_width()) {
            self.line(&line);
        }
    }

    pub(crate) fn section(&mut self, title: &str, lines: impl IntoIterator<Item: AsRef<str>>) {
        self.line("");
        self.line(title);
        for line in lines {
            self.line(&format!("{:INDENT$}{}", "", line.as_ref()));
        }
    }

    pub(crate) fn display(&mut self, formula: &str) {
        self.line(&format!("\\[\n{formula}\n\\]"));
    }

    /// Appends a claim in LaTeX, under a comment with its name and source.
    pub(crate) fn claim(&mut self, claim: &ClaimShown) {
        let ClaimShown { name, kind, when, condition, .. } = claim;
        let source = claim.source.map_or_else(String::new, |source| format!(": {source}"));
        let when = if when.is_empty() { String::new() } else { format!(", when {when}") };
        self.line(&format!("% {kind} {name}{when}{source}"));
        let is_bracket = *kind == ClaimKind::Bracket.keyword();
        let index = if is_bracket { format!("_{{{}}}", Latex.name(name)) } else { String::new() };
        let equations = claim.equations.iter();
        let rows = equations
            .map(|(left, right)| breaking::equation(&format!("{left}{index}"), right, PAGE_WIDTH))
            .chain((!condition.is_empty()).then(|| format!("&\\text{{where }} {condition}")));
        self.display(&aligned(rows.collect()));
    }
}

pub(crate) fn singletons(entries: &[String]) -> MatrixText {
    entries.iter().map(|entry| vec![entry.clone()]).collect()
}

const INDENT: usize = 2;

pub(crate) fn matrix(rows: &[Vec<String>], left: char, right: char) -> Vec<String> {
    layout::matrix(rows, left, right, screen_width().saturating_sub(INDENT))
}

pub(crate) fn paragraph(text: &str) -> Vec<String> {
    lines(text, screen_width().saturating_sub(INDENT))
}

pub(crate) fn column(entries: &[String]) -> Vec<String> {
    matrix(&singletons(entries), '[', ']')
}

pub(crate) fn aligned(lines: Vec<String>) -> String {
    format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", lines.join(" \\\\\n"))
}
