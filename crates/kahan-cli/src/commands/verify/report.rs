//! What `kahan verify` found: each claim with its outcome, and the forms in which that is shown.

use std::time::Duration;

use kahan_paper::{Claim, Established, Outcome};
use serde_json::{Value, json};

use super::{lines, summary, table};
use crate::printing::Answer;

/// What there is to say of a block without claims.
pub(super) const NO_CLAIMS: &str = "0 claims: the block claims nothing; add `integral NAME = …;`, `density NAME = …;` or `bracket NAME { … }`";

/// A claim with its outcome.
pub(super) struct Row<'a> {
    pub(super) id: String,
    pub(super) system: String,
    pub(super) source: String,
    /// What is claimed, in one line.
    pub(super) statement: String,
    /// The claim of the paper; none of a field of one's own has one.
    pub(super) claim: Option<&'a Claim>,
    pub(super) established: Established,
}

/// All of them.
pub(super) struct Report<'a> {
    pub(super) rows: Vec<Row<'a>>,
    /// What the paper leaves open.
    pub(super) open: &'a [(&'a str, &'a str)],
    pub(super) elapsed: Duration,
}

/// How much is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// One screen: a line a section.
    Summary,
    /// A line a claim.
    Lines,
    /// Every claim with its statement, its source and its time.
    Table,
    /// One JSON object.
    Json,
}

impl Report<'_> {
    /// In one of its forms; a complaint if a claim failed.
    pub(super) fn answer(&self, form: Form) -> Answer {
        let failed: Vec<&str> = self.failed().map(|row| row.id.as_str()).collect();
        let complaint = (!failed.is_empty())
            .then(|| format!("{} of {} claims failed: {}", failed.len(), self.rows.len(), failed.join(", ")));
        let answer = match form {
            Form::Json => Answer::json(&self.json()),
            _ if self.rows.is_empty() => Answer::text(format!("{NO_CLAIMS}\n")),
            Form::Summary => Answer::text(summary::text(self)),
            Form::Lines => Answer::text(lines::text(self)),
            Form::Table => Answer::text(table::text(self)),
        };
        Answer { complaint, ..answer }
    }

    /// The claims that do not hold.
    pub(super) fn failed(&self) -> impl Iterator<Item = &Row<'_>> {
        self.rows.iter().filter(|row| row.established.outcome == Outcome::Failed)
    }

    /// How many claims came out how, in one line without its end.
    pub(super) fn totals(&self) -> String {
        let count =
            |keep: fn(Outcome) -> bool| self.rows.iter().filter(|row| keep(row.established.outcome)).count();
        let kinds = [
            (count(|o| o == Outcome::Proved), "proved over Q"),
            (count(|o| o == Outcome::ProvedModP), "proved mod p"),
            (count(|o| matches!(o, Outcome::Exact(_))), "exact at points"),
            (count(|o| matches!(o, Outcome::Numerical(_))), "numerical"),
            (count(|o| o == Outcome::Misprint), "misprinted"),
        ];
        let found = kinds.iter().filter(|(n, _)| *n > 0).map(|(n, what)| format!("{n} {what}, "));
        let claims = if self.rows.len() == 1 { "claim" } else { "claims" };
        let failed = self.failed().count();
        format!("{} {claims}: {}{failed} failed", self.rows.len(), found.collect::<String>())
    }

    fn json(&self) -> Value {
        let claims: Vec<Value> = self.rows.iter().map(Row::json).collect();
        let open: Vec<Value> =
            self.open.iter().map(|(title, why)| json!({ "statement": title, "detail": why })).collect();
        json!({ "claims": claims, "failed": self.failed().count(), "open": open })
    }
}

impl Row<'_> {
    /// What the outcome rests on, or what is wrong; of a misprint also what is printed.
    pub(super) fn detail(&self) -> String {
        let detail = &self.established.detail;
        match self.claim.and_then(Claim::printed) {
            Some(printed) if self.established.outcome == Outcome::Misprint => {
                format!("printed: {}; {detail}", in_one_line(printed))
            }
            _ => detail.clone(),
        }
    }

    pub(super) fn milliseconds(&self) -> f64 {
        self.established.elapsed.as_secs_f64() * 1000.0
    }

    fn json(&self) -> Value {
        json!({
            "id": self.id,
            "system": self.system,
            "source": self.source,
            "statement": self.statement,
            "outcome": self.established.outcome.key(),
            "detail": format!("{} ({:.1} ms)", self.detail(), self.milliseconds()),
        })
    }
}

/// The words of a statement, one space apart.
pub(super) fn in_one_line(statement: &str) -> String {
    statement.split_whitespace().collect::<Vec<_>>().join(" ")
}
