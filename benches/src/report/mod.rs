//! Writes measurements as sections with their limits, as text or JSON.

mod compile;
mod drift;
mod ensembles;
mod journeys;
mod orders;
mod run_time;
mod steps;
mod tiers;

use std::fmt;
use std::path::Path;

use serde_json::json;

use crate::limit::Limit;
use crate::machine;
use crate::table::Table;

pub(crate) use compile::compile;
pub(crate) use drift::drift;
pub(crate) use ensembles::{ensemble_times, ensembles};
pub(crate) use journeys::journeys;
pub(crate) use orders::orders;
pub(crate) use run_time::run_time;
pub(crate) use steps::{step_times, steps};
pub(crate) use tiers::{tier_prices, tiers};

pub(crate) struct Section {
    pub(crate) title: String,
    pub(crate) text: String,
    pub(crate) table: Table,
}

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "### {}\n", self.title)?;
        if !self.text.is_empty() {
            writeln!(f, "{}\n", self.text)?;
        }
        write!(f, "{}", self.table)
    }
}

pub(crate) fn result(root: &Path, sections: &[Section], limits: &[Limit]) -> String {
    let sections = sections.iter().map(|section| {
        let Section { title, text, table } = section;
        json!({ "title": title, "text": text, "columns": table.head, "rows": table.rows })
    });
    let result = json!({
        "machine": machine::processor(),
        "compiler": machine::compiler(),
        "commit": machine::commit(root),
        "sections": sections.collect::<Vec<_>>(),
        "limits": limits.iter().map(Limit::to_json).collect::<Vec<_>>(),
    });
    format!("{result:#}\n")
}
