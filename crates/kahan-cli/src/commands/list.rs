//! `kahan list`: the catalog in one table.

use clap::Args;
use kahan_study::{Systems, list};
use serde_json::json;

use crate::printing::layout::{Rows, table};
use crate::printing::{Answer, Refusal};

/// Lists the systems of the catalog.
///
/// Names with variables `x[i]` are families, which take --sites N.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  kahan list\n  kahan list --json")]
pub(crate) struct List {
    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

impl List {
    /// The table, or the catalog as one object.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let listed = list(&Systems)?;
        if self.json {
            return Ok(Answer::json(&json!(listed)));
        }
        let row = |name: &str, variables: String, parameters: &[String], claims: &[String], title: &str| {
            vec![name.to_owned(), variables, parameters.join(","), claims.len().to_string(), title.to_owned()]
        };
        let systems = listed
            .systems
            .iter()
            .map(|one| row(one.name, one.variables.join(","), &one.parameters, &one.claims, one.title));
        let families = listed.families.iter().map(|one| {
            let arrays: Vec<String> = one.arrays.iter().map(|array| format!("{array}[i]")).collect();
            row(one.name, arrays.join(","), &one.parameters, &one.claims, one.title)
        });
        let headings = ["name", "variables", "parameters", "claims", "title"].map(str::to_owned);
        let rows: Rows = [headings.to_vec()].into_iter().chain(systems).chain(families).collect();
        Ok(Answer::text(table(&rows, 1).join("\n") + "\n"))
    }
}
