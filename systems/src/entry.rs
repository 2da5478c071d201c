//! Entries of the catalog: names, the block as text, the closed solution of the flow, and the
//! sources of the claims. The text is cut out of the system's source file, and therefore equals the
//! text that the macro compiles.

use std::ops::Range;

use kahan_algebra::lexer::lex;
use kahan_algebra::token::TokenKind;

use crate::solution::ClosedFlow;

/// A system of the catalog.
///
/// ```
/// use kahan_systems::registry::find;
///
/// let entry = find("weierstrass").unwrap();
/// assert_eq!((entry.type_name, entry.parameters), ("Weierstrass", &[(5, 4)][..]));
/// assert!(entry.text().contains("ydot = 6*x^2 - a;"));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The command-line name, such as `e1`.
    pub command: &'static str,
    /// The name of the type in this crate, such as `E1`.
    pub type_name: &'static str,
    /// The usual name, such as `Euler top`.
    pub name: &'static str,
    /// A description in one line.
    pub title: &'static str,
    /// The contents of the source file that contains the block.
    pub(crate) file: &'static str,
    /// For each parameter the numerator and denominator of a value that tests use. The denominators
    /// are powers of two, so that floats represent the values exactly.
    pub parameters: &'static [(i64, i64)],
    /// The closed solution of the flow, if known.
    pub flow: Option<ClosedFlow>,
    /// Each claim's name and source: a place in the paper, or `FOUND` if `kahan discover` found it.
    pub sources: &'static [(&'static str, &'static str)],
}

/// The source of claims that `kahan discover` found from the equations.
pub(crate) const FOUND: &str = "found by kahan discover";

/// Makes the entry of one of the systems E1 to E6. The sources of its claims are rows of the
/// paper's tables. The last argument is appended to the source of the bracket Q.
macro_rules! row_of_the_tables {
    ($i:literal, $title:literal $(, $remark:literal)?) => {
        Entry::new(concat!("e", $i), concat!("E", $i), $title, include_str!(concat!("e", $i, ".rs")))
            .with_flow(|_, start| trajectory(FlowSolution::through(&point(start)?), FlowSolution::at))
            .with_sources(&[
                ("H", concat!("Table 2, i = ", $i)),
                ("K", concat!("Table 2, i = ", $i)),
                ("rho", "Theorem 1"),
                ("P", concat!("Table 3, i = ", $i, ", and Theorem 2")),
                ("Q", concat!("Table 4, i = ", $i, $($remark,)? ", and Theorem 2")),
            ])
    };
}
pub(crate) use row_of_the_tables;

impl Entry {
    /// Makes an entry without parameters, closed solution and claims. Its name is `type_name`.
    pub(crate) const fn new(
        command: &'static str,
        type_name: &'static str,
        title: &'static str,
        file: &'static str,
    ) -> Self {
        Entry { command, type_name, name: type_name, title, file, parameters: &[], flow: None, sources: &[] }
    }

    pub(crate) const fn named(self, name: &'static str) -> Self {
        Entry { name, ..self }
    }

    pub(crate) const fn with_parameters(self, parameters: &'static [(i64, i64)]) -> Self {
        Entry { parameters, ..self }
    }

    pub(crate) const fn with_flow(self, flow: ClosedFlow) -> Self {
        Entry { flow: Some(flow), ..self }
    }

    pub(crate) const fn with_sources(self, sources: &'static [(&'static str, &'static str)]) -> Self {
        Entry { sources, ..self }
    }

    /// Returns the block in the language of `kahan!`, without `kahan! {` and the closing brace.
    #[must_use]
    pub fn text(&self) -> &'static str {
        block_range(self.file).map_or("", |range| &self.file[range])
    }

    /// Returns the source of a claim, such as its place in the paper.
    #[must_use]
    pub fn source(&self, claim: &str) -> Option<&'static str> {
        self.sources.iter().find(|(name, _)| *name == claim).map(|(_, source)| *source)
    }
}

/// Returns the byte range of the first block in a Rust source file, or `None` if no block is
/// complete. The block is the text between `kahan! {` and the matching brace.
#[must_use]
pub fn block_range(file: &str) -> Option<Range<usize>> {
    const OPENING: &str = "kahan! {";
    let line = if file.starts_with(OPENING) { 0 } else { file.find(&format!("\n{OPENING}"))? + 1 };
    let start = line + OPENING.len();
    let lexed = lex(&file[start..]);
    let mut depth = 0;
    for (token, range) in lexed.tokens.iter().zip(&lexed.ranges) {
        match token.kind {
            TokenKind::Close('}') if depth == 0 => return Some(start..start + range.start),
            TokenKind::Open('{') => depth += 1,
            TokenKind::Close('}') => depth -= 1,
            _ => {}
        }
    }
    None
}
