//! `kahan verify SYSTEM`: a line a claim, and what is wrong in full; with `--all`, every claim with
//! its statement, where it is from, and its time.

use kahan_algebra::render::lines as breakable;
use kahan_paper::Outcome;
use kahan_study::{Open, Verdict, Verdicts};
use kahan_systems::registry::find;

use super::totals;
use crate::printing::layout::{columns, screen_width, widths};
use crate::printing::shorten;

/// Words of which less could be seen are left out.
const LEAST_SEEN: usize = 12;

/// The claims, the totals, and how to see more.
pub(super) fn lines(verdicts: &Verdicts) -> String {
    let cells = verdicts.claims.iter().map(|row| {
        let is_misprint = row.outcome == Outcome::Misprint;
        let outcome = if is_misprint { "misprint corrected".to_owned() } else { row.outcome.words() };
        vec![row.id.clone(), outcome]
    });
    let cells: Vec<Vec<String>> = cells.collect();
    let mut widths = widths(&cells);
    let room = screen_width().saturating_sub(2 + widths.iter().map(|width| width + 2).sum::<usize>());
    widths.push(room);
    let mut text = verdicts.claims.first().map_or_else(Vec::new, |row| title(&row.system));
    let mut is_whole = true;
    for (row, mut cells) in verdicts.claims.iter().zip(cells) {
        let is_failed = row.outcome == Outcome::Failed;
        // What failed is said in full below.
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
    text.push(totals(verdicts));
    if !is_whole {
        text.push("--all shows statements in full, with their sources and times".to_owned());
    }
    text.join("\n") + "\n"
}

/// The claims by system, what the paper leaves open, the totals.
pub(super) fn in_full(verdicts: &Verdicts) -> String {
    let cells = verdicts.claims.iter().map(|row| {
        let time = format!("{:>7.1} ms", 1000.0 * row.seconds.unwrap_or_default());
        vec![row.id.clone(), row.outcome.words(), time]
    });
    let cells: Vec<Vec<String>> = cells.collect();
    let widths = widths(&cells);
    let room = screen_width().saturating_sub(2);
    let mut text = Vec::new();
    let mut system = None;
    for (row, cells) in verdicts.claims.iter().zip(&cells) {
        if system != Some(&row.system) {
            text.extend(system.map(|_| String::new()));
            text.extend(title(&row.system));
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
    if !verdicts.open.is_empty() {
        text.push("Left open by the paper".to_owned());
        let open = verdicts.open.iter();
        text.extend(open.map(|Open { statement, detail }| format!("  {statement}: {detail}")));
        text.push(String::new());
    }
    text.push(format!("{}; {:.2} s", totals(verdicts), verdicts.seconds.unwrap_or_default()));
    text.join("\n") + "\n"
}

/// What the claims of a system stand under, as lines of the screen.
fn title(system: &str) -> Vec<String> {
    let title = match find(system) {
        Some(entry) if entry.command == system => format!("{system}: {}", entry.title),
        _ if system == "general" => "general: what holds for every quadratic field".to_owned(),
        _ => system.to_owned(),
    };
    breakable(&title, screen_width())
}
