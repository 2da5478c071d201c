//! One system of the catalog: its names, the text of its block, the closed solution of its flow,
//! the source of every claim.
//!
//! The text is the very text that the macro compiles: it is cut out of the system's own source
//! file. So what a reader of the text gets and what the library offers cannot differ. Nothing is
//! parsed here beyond finding the block.

use std::ops::Range;

use kahan_algebra::lexer::lex;
use kahan_algebra::token::TokenKind;

use crate::solution::ClosedFlow;

/// One system of the catalog.
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
    /// Its name on the command line: `e1`.
    pub command: &'static str,
    /// Its type in this crate: `E1`.
    pub type_name: &'static str,
    /// Its name as people write it: `Euler top`.
    pub name: &'static str,
    /// What it is, in one line.
    pub title: &'static str,
    /// The source file with the block: `include_str!` of the file itself.
    pub(crate) file: &'static str,
    /// A value for each parameter, numerator and denominator, at which tests run it.
    ///
    /// The values are of the size that the literature gives them, and dyadic, so that every float
    /// has them exactly.
    pub parameters: &'static [(i64, i64)],
    /// The closed solution of its flow, where one is known.
    pub flow: Option<ClosedFlow>,
    /// Where each claim is from, by the claim's name: its place in the paper, or `FOUND`.
    pub sources: &'static [(&'static str, &'static str)],
}

/// The source of a claim that is in no paper: it was found from the equations alone.
pub(crate) const FOUND: &str = "found by kahan discover";

/// The entry of an integrable system E1 to E6, whose claims are the cells of one row of the paper's
/// tables; the last argument is a remark on the tensor Q.
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
    /// A system without parameters, closed solution and claims, whose name is that of its type.
    pub(crate) const fn new(
        command: &'static str,
        type_name: &'static str,
        title: &'static str,
        file: &'static str,
    ) -> Self {
        Entry { command, type_name, name: type_name, title, file, parameters: &[], flow: None, sources: &[] }
    }

    /// Sets the name as people write it.
    pub(crate) const fn named(self, name: &'static str) -> Self {
        Entry { name, ..self }
    }

    /// Sets a value for each parameter.
    pub(crate) const fn with_parameters(self, parameters: &'static [(i64, i64)]) -> Self {
        Entry { parameters, ..self }
    }

    /// Sets the closed solution of the flow.
    pub(crate) const fn with_flow(self, flow: ClosedFlow) -> Self {
        Entry { flow: Some(flow), ..self }
    }

    /// Sets where the claims are from.
    pub(crate) const fn with_sources(self, sources: &'static [(&'static str, &'static str)]) -> Self {
        Entry { sources, ..self }
    }

    /// The block in the language of `kahan!`, without `kahan! {` and its closing brace.
    #[must_use]
    pub fn text(&self) -> &'static str {
        block_range(self.file).map_or("", |range| &self.file[range])
    }

    /// The place in the paper of the claim with this name, or where else it is from.
    #[must_use]
    pub fn source(&self, claim: &str) -> Option<&'static str> {
        self.sources.iter().find(|(name, _)| *name == claim).map(|(_, source)| *source)
    }
}

/// Where the first block of a Rust source file stands: the bytes between `kahan! {` at the
/// beginning of a line and the matching brace. `None` if there is no such line or the brace is
/// never closed.
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
