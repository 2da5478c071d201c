//! The table of `kahan verify`, and its JSON.

use std::time::Duration;

use kahan_algebra::render::lines;
use kahan_paper::{Established, Outcome};
use kahan_systems::registry::find;
use serde_json::{Value, json};

use crate::printing::layout::screen_width;
use crate::printing::{Answer, columns, widths};

/// The columns by which the lines of a system are indented.
const INDENT: usize = 2;

/// What there is to say of a block without claims.
pub(super) const NO_CLAIMS: &str = "0 claims: the block claims nothing; add `integral NAME = …;`, `density NAME = …;` or `bracket NAME { … }`";

/// A claim with its outcome.
pub(super) struct Row {
    pub(super) id: String,
    pub(super) system: String,
    pub(super) source: String,
    pub(super) statement: String,
    pub(super) established: Established,
}

/// All of them.
pub(super) struct Report<'a> {
    pub(super) rows: Vec<Row>,
    /// What the paper leaves open.
    pub(super) open: &'a [(&'a str, &'a str)],
    pub(super) elapsed: Duration,
}

impl Report<'_> {
    /// As text or as one JSON object; a complaint if a claim failed.
    pub(super) fn answer(&self, as_json: bool) -> Answer {
        let failed: Vec<&str> = self
            .rows
            .iter()
            .filter(|row| row.established.outcome == Outcome::Failed)
            .map(|row| row.id.as_str())
            .collect();
        let complaint = (!failed.is_empty())
            .then(|| format!("{} of {} claims failed: {}", failed.len(), self.rows.len(), failed.join(", ")));
        let answer = if as_json {
            let claims: Vec<Value> = self.rows.iter().map(Row::json).collect();
            let open: Vec<Value> =
                self.open.iter().map(|(title, why)| json!({ "statement": title, "detail": why })).collect();
            Answer::json(&json!({ "claims": claims, "failed": failed.len(), "open": open }))
        } else {
            Answer::text(self.table() + &self.open_problems() + &self.totals())
        };
        Answer { complaint, ..answer }
    }

    fn table(&self) -> String {
        let cells: Vec<Vec<String>> = self.rows.iter().map(Row::cells).collect();
        let widths = widths(&cells);
        let room = screen_width().saturating_sub(INDENT);
        let mut text = String::new();
        let mut system = None;
        for (row, cells) in self.rows.iter().zip(&cells) {
            if system != Some(&row.system) {
                text.push_str(if system.is_some() { "\n" } else { "" });
                text.push_str(&(lines(&title(&row.system), screen_width()).join("\n") + "\n"));
                system = Some(&row.system);
            }
            let line = columns(cells, &widths);
            if line.chars().count() <= room {
                text.push_str(&format!("{:INDENT$}{line}\n", ""));
            } else {
                text.push_str(&format!("{:INDENT$}{}\n", "", row.id));
                text.push_str(&format!("{:INDENT$}  {}\n", "", columns(&cells[1..], &widths[1..])));
            }
            text.push_str(&format!("    {}\n", row.statement_and_source()));
            if matches!(row.established.outcome, Outcome::Failed | Outcome::Misprint) {
                text.push_str(&format!("    {}\n", row.established.detail));
            }
        }
        if self.rows.is_empty() { text } else { text + "\n" }
    }

    fn open_problems(&self) -> String {
        if self.open.is_empty() {
            return String::new();
        }
        let lines = self.open.iter().map(|(title, why)| format!("  {title}: {why}\n"));
        format!("Left open by the paper\n{}\n", lines.collect::<String>())
    }

    fn totals(&self) -> String {
        if self.rows.is_empty() {
            return format!("{NO_CLAIMS}\n");
        }
        let count =
            |keep: fn(Outcome) -> bool| self.rows.iter().filter(|row| keep(row.established.outcome)).count();
        let parts = [
            (count(|o| o == Outcome::Proved), "proved by normal forms over Q"),
            (count(|o| o == Outcome::ProvedModP), "proved mod p (error < 2^-100)"),
            (count(|o| matches!(o, Outcome::Exact(_))), "exact at points"),
            (count(|o| matches!(o, Outcome::Numerical(_))), "numerical"),
            (count(|o| o == Outcome::Misprint), "misprints corrected"),
        ];
        let found: Vec<String> =
            parts.iter().filter(|(n, _)| *n > 0).map(|(n, what)| format!("{n} {what}")).collect();
        let failed = count(|o| o == Outcome::Failed);
        let claims = if self.rows.len() == 1 { "claim" } else { "claims" };
        let found = if found.is_empty() { String::new() } else { found.join(", ") + ", " };
        format!("{} {claims}: {found}{failed} failed; {:.2} s\n", self.rows.len(), self.elapsed.as_secs_f64())
    }
}

impl Row {
    fn cells(&self) -> Vec<String> {
        vec![self.id.clone(), self.established.outcome.words(), format!("{:>7.1} ms", self.milliseconds())]
    }

    /// The statement in one line, and where it is from.
    fn statement_and_source(&self) -> String {
        let statement = self.statement.split_whitespace().collect::<Vec<_>>().join(" ");
        if self.source.is_empty() { statement } else { format!("{statement}    // {}", self.source) }
    }

    fn json(&self) -> Value {
        json!({
            "id": self.id,
            "system": self.system,
            "source": self.source,
            "statement": self.statement.split_whitespace().collect::<Vec<_>>().join(" "),
            "outcome": self.established.outcome.key(),
            "detail": format!("{} ({:.1} ms)", self.established.detail, self.milliseconds()),
        })
    }

    fn milliseconds(&self) -> f64 {
        self.established.elapsed.as_secs_f64() * 1000.0
    }
}

fn title(system: &str) -> String {
    match find(system) {
        Some(entry) if entry.command == system => format!("{system}: {}", entry.title),
        _ if system == "general" => "general: what holds for every quadratic field".to_owned(),
        _ => system.to_owned(),
    }
}
