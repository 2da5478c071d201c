//! Verdicts as plain text: a summary, one line for each claim (three if it fails), or a description
//! of each claim.

mod claims;
mod summary;

use super::claim::Outcome;
use super::verdict::Verdicts;

impl Verdicts {
    /// Counts the claims by outcome, in one line without a newline.
    #[must_use]
    pub fn totals(&self) -> String {
        let words = ["proved over Q", "proved mod p", "exact at points", "numerical", "misprinted"];
        let counts = Outcome::counts(self.claims.iter().map(|verdict| verdict.outcome));
        let found = counts.iter().zip(words).filter(|(count, _)| **count > 0);
        let found = found.map(|(count, what)| format!("{count} {what}, "));
        let claims = if self.claims.len() == 1 { "claim" } else { "claims" };
        format!("{} {claims}: {}{} failed", self.claims.len(), found.collect::<String>(), self.failed)
    }
}
