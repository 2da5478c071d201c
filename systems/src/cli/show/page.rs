//! What `kahan show` writes is put together from: sections of plain text, displays of LaTeX, matrices.

use kahan_algebra::render::MatrixText;

use super::super::output::matrix;

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

    pub(super) fn section(&mut self, title: &str, lines: Vec<String>) {
        self.line("");
        self.line(title);
        for line in lines {
            self.line(&format!("  {line}"));
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

/// A column in brackets, a line a row.
pub(super) fn column(entries: &[String]) -> Vec<String> {
    matrix(&singletons(entries), '[', ']')
}

/// A matrix in LaTeX.
pub(super) fn environment(name: &str, rows: &[Vec<String>]) -> String {
    let rows: Vec<String> = rows.iter().map(|row| row.join(" & ")).collect();
    format!("\\begin{{{name}}}\n{}\n\\end{{{name}}}", rows.join(" \\\\\n"))
}

/// Equations in LaTeX, one below the other.
pub(super) fn aligned(lines: Vec<String>) -> String {
    format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", lines.join(" \\\\\n"))
}
