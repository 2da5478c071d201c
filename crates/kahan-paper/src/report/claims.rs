//! Writes verdicts as text: in short form, one line for a claim and three for a failed claim; in
//! long form, the claim with its statement, source and time.

use kahan_algebra::render::{columns, lines as breakable, shorten, widths};
use kahan_systems::registry::find;

use crate::claim::Outcome;
use crate::verdict::{OpenQuestion, Verdict, Verdicts};

/// If a line has room for fewer characters than this, it shows no excerpt of the statement.
const LEAST_SEEN: usize = 12;

impl Verdicts {
    /// Writes one line of at most `width` characters for each claim, the reasons below a claim that
    /// fails, and then the totals.
    #[must_use]
    pub fn lines(&self, width: usize) -> String {
        let cells = self.claims.iter().map(|row| {
            let is_misprint = row.outcome == Outcome::Misprint;
            let outcome = if is_misprint { "misprint corrected".to_owned() } else { row.outcome.words() };
            vec![row.id.clone(), outcome]
        });
        let cells: Vec<Vec<String>> = cells.collect();
        let mut widths = widths(&cells);
        let room = width.saturating_sub(2 + widths.iter().map(|width| width + 2).sum::<usize>());
        widths.push(room);
        let mut text = self.claims.first().map_or_else(Vec::new, |row| title(&row.system, width));
        let mut is_whole = true;
        for (row, mut cells) in self.claims.iter().zip(cells) {
            let is_failed = row.outcome == Outcome::Failed;
            let statement = if is_failed { "" } else { &row.statement };
            let whole = if row.source.is_empty() { statement } else { &row.source };
            let about = if room < LEAST_SEEN { String::new() } else { shorten(whole, room) };
            is_whole &= about == statement;
            cells.push(about);
            text.push(format!("  {}", columns(&cells, &widths)));
            if is_failed {
                text.extend([&row.statement, &row.detail].map(|line| format!("    {line}")));
            }
        }
        text.push(self.totals());
        if !is_whole {
            text.push("--all shows statements in full, with their sources and times".to_owned());
        }
        text.join("\n") + "\n"
    }

    /// Writes each system's claims with statement, source and time, then open questions and totals.
    #[must_use]
    pub fn in_full(&self, width: usize) -> String {
        let cells = self.claims.iter().map(|row| {
            let time = format!("{:>7.1} ms", 1000.0 * row.seconds.unwrap_or_default());
            vec![row.id.clone(), row.outcome.words(), time]
        });
        let cells: Vec<Vec<String>> = cells.collect();
        let widths = widths(&cells);
        let room = width.saturating_sub(2);
        let mut text = Vec::new();
        let mut system = None;
        for (row, cells) in self.claims.iter().zip(&cells) {
            if system != Some(&row.system) {
                text.extend(system.map(|_| String::new()));
                text.extend(title(&row.system, width));
                system = Some(&row.system);
            }
            let line = columns(cells, &widths);
            if line.chars().count() <= room {
                text.push(format!("  {line}"));
            } else {
                text.push(format!("  {}", row.id));
                text.push(format!("    {}", columns(&cells[1..], &widths[1..])));
            }
            let Verdict { statement, source, .. } = row;
            let source = if source.is_empty() { String::new() } else { format!("    // {source}") };
            text.push(format!("    {statement}{source}"));
            if matches!(row.outcome, Outcome::Failed | Outcome::Misprint) {
                text.push(format!("    {}", row.detail));
            }
        }
        text.push(String::new());
        if !self.open.is_empty() {
            text.push("Left open by the paper".to_owned());
            let open = self.open.iter();
            text.extend(open.map(|OpenQuestion { statement, detail }| format!("  {statement}: {detail}")));
            text.push(String::new());
        }
        text.push(format!("{}; {:.2} s", self.totals(), self.seconds.unwrap_or_default()));
        text.join("\n") + "\n"
    }
}

fn title(system: &str, width: usize) -> Vec<String> {
    let title = match find(system) {
        Some(entry) if entry.command == system => format!("{system}: {}", entry.title),
        _ if system == "general" => "general: what holds for every quadratic field".to_owned(),
        _ => system.to_owned(),
    };
    breakable(&title, width)
}
