//! `kahan verify --all`: every claim with its statement, where it is from, and its time.

use kahan_algebra::render::lines;
use kahan_paper::Outcome;
use kahan_study::{Open, Verdict, Verdicts};
use kahan_systems::registry::find;

use super::totals;
use crate::printing::layout::screen_width;
use crate::printing::{columns, widths};

/// The columns by which the lines of a system are indented.
const INDENT: usize = 2;

/// The claims by system, what the paper leaves open, the totals.
pub(super) fn text(verdicts: &Verdicts) -> String {
    let (claims, open) = (claims(&verdicts.claims), open_problems(&verdicts.open));
    let (totals, seconds) = (totals(verdicts), verdicts.seconds.unwrap_or_default());
    format!("{claims}\n{open}{totals}; {seconds:.2} s\n")
}

fn claims(rows: &[Verdict]) -> String {
    let cells: Vec<Vec<String>> = rows.iter().map(cells).collect();
    let widths = widths(&cells);
    let room = screen_width().saturating_sub(INDENT);
    let mut text = String::new();
    let mut system = None;
    for (row, cells) in rows.iter().zip(&cells) {
        if system != Some(&row.system) {
            text.push_str(if system.is_some() { "\n" } else { "" });
            text.push_str(&(title(&row.system).join("\n") + "\n"));
            system = Some(&row.system);
        }
        let line = columns(cells, &widths);
        if line.chars().count() <= room {
            text.push_str(&format!("{:INDENT$}{line}\n", ""));
        } else {
            text.push_str(&format!("{:INDENT$}{}\n", "", row.id));
            text.push_str(&format!("{:INDENT$}  {}\n", "", columns(&cells[1..], &widths[1..])));
        }
        text.push_str(&format!("    {}\n", statement_and_source(row)));
        if matches!(row.outcome, Outcome::Failed | Outcome::Misprint) {
            text.push_str(&format!("    {}\n", row.detail));
        }
    }
    text
}

fn cells(row: &Verdict) -> Vec<String> {
    vec![row.id.clone(), row.outcome.words(), format!("{:>7.1} ms", 1000.0 * row.seconds.unwrap_or_default())]
}

fn statement_and_source(row: &Verdict) -> String {
    let Verdict { statement, source, .. } = row;
    if source.is_empty() { statement.clone() } else { format!("{statement}    // {source}") }
}

fn open_problems(open: &[Open]) -> String {
    if open.is_empty() {
        return String::new();
    }
    let lines = open.iter().map(|Open { statement, detail }| format!("  {statement}: {detail}\n"));
    format!("Left open by the paper\n{}\n", lines.collect::<String>())
}

/// What the claims of a system stand under, as lines of the screen.
pub(super) fn title(system: &str) -> Vec<String> {
    let title = match find(system) {
        Some(entry) if entry.command == system => format!("{system}: {}", entry.title),
        _ if system == "general" => "general: what holds for every quadratic field".to_owned(),
        _ => system.to_owned(),
    };
    lines(&title, screen_width())
}
