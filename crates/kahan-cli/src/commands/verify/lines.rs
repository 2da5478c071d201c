//! `kahan verify SYSTEM`: a line a claim, and what is wrong in full.

use kahan_paper::Outcome;
use kahan_study::{Verdict, Verdicts};

use super::table::title;
use super::totals;
use crate::printing::layout::screen_width;
use crate::printing::{columns, shorten, widths};

/// Words of which less could be seen are left out.
const LEAST_SEEN: usize = 12;

/// The claims, the totals, and how to see more.
pub(super) fn text(verdicts: &Verdicts) -> String {
    let cells: Vec<Vec<String>> = verdicts.claims.iter().map(cells).collect();
    let mut widths = widths(&cells);
    let room = screen_width().saturating_sub(2 + widths.iter().map(|width| width + 2).sum::<usize>());
    widths.push(room);
    let mut text = verdicts.claims.first().map_or_else(Vec::new, |row| title(&row.system));
    let mut is_whole = true;
    for (row, cells) in verdicts.claims.iter().zip(&cells) {
        let is_failed = row.outcome == Outcome::Failed;
        // What failed is said in full below.
        let statement = if is_failed { "" } else { &row.statement };
        let whole = if row.source.is_empty() { statement } else { &row.source };
        let about = if room < LEAST_SEEN { String::new() } else { shorten(whole, room) };
        is_whole &= about == statement;
        text.push(format!("  {}", columns(&[cells.as_slice(), &[about]].concat(), &widths)));
        if is_failed {
            text.push(format!("    {}", row.statement));
            text.push(format!("    {}", row.detail));
        }
    }
    text.push(totals(verdicts));
    if !is_whole {
        text.push("--all shows statements in full, with their sources and times".to_owned());
    }
    text.join("\n") + "\n"
}

fn cells(row: &Verdict) -> Vec<String> {
    let outcome = match row.outcome {
        Outcome::Misprint => "misprint corrected".to_owned(),
        outcome => outcome.words(),
    };
    vec![row.id.clone(), outcome]
}
