//! The text form of claims. Each claim has one line where possible:
//! ```text
//! NAME | PLACE | STATEMENT
//! NAME | PLACE |
//!     the first line of a STATEMENT;
//!     its second line
//!     misprint A5: what the paper prints instead
//!     refuted: a point, and the values of both sides there
//!     explains B8
//!     within q: 1/50, 1/4
//! ```
//!
//! Notes name the errata that a claim corrects or explains, and intervals for numerical tests.

use kahan_algebra::rational::Rational;

use super::super::claim::Claim;
use super::super::erratum::Erratum;

/// The text of a claim, and the notes that follow it.
pub(super) struct ClaimText {
    pub(super) head: String,
    notes: Vec<String>,
}

impl ClaimText {
    pub(super) fn all(text: &str) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        for line in text.lines().filter(|line| !line.trim().is_empty()) {
            let is_indented = line.starts_with(' ');
            let line = line.trim();
            let is_note =
                ["misprint ", "refuted:", "explains ", "within "].iter().any(|n| line.starts_with(n));
            match all.last_mut().filter(|_| is_indented) {
                None => all.push(ClaimText { head: line.to_owned(), notes: Vec::new() }),
                Some(written) if is_note => written.notes.push(line.to_owned()),
                Some(written) => {
                    let continued = written.notes.last_mut().unwrap_or(&mut written.head);
                    *continued = format!("{continued} {line}");
                }
            }
        }
        all
    }

    /// Adds the notes to a claim. Panics if a note is malformed.
    pub(super) fn annotate(&self, claim: Claim) -> Claim {
        let annotated = self.notes.iter().try_fold(claim, |claim, note| {
            let (word, rest) = note.split_once([' ', ':'])?;
            Some(match word {
                "refuted" => claim.refuted(rest.trim()),
                "explains" => claim.explaining(Erratum::parse(rest)?),
                "misprint" => {
                    let (erratum, printed) = rest.split_once(':')?;
                    claim.misprinted(Erratum::parse(erratum)?, printed.trim())
                }
                _ => {
                    let (name, interval) = rest.split_once(": ")?;
                    let (low, high) = interval.split_once(", ")?;
                    claim.within(name, Rational::parse(low)?, Rational::parse(high)?)
                }
            })
        });
        annotated.unwrap_or_else(|| panic!("a note of `{}` is malformed: {:?}", self.head, self.notes))
    }
}

/// Reads claims. `claim` makes each from its name, place and statement. Panics if a claim lacks a
/// place or a statement.
pub(super) fn read(text: &str, claim: impl Fn(&str, &str, &str) -> Claim) -> Vec<Claim> {
    let one = |written: ClaimText| {
        let mut parts = written.head.splitn(3, " | ");
        match (parts.next(), parts.next(), parts.next()) {
            (Some(name), Some(place), Some(statement)) => written.annotate(claim(name, place, statement)),
            _ => panic!("`{}` is no name, place and statement", written.head),
        }
    };
    ClaimText::all(text).into_iter().map(one).collect()
}
