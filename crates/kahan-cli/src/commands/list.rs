//! The command `kahan list`, which prints the catalog as a table.

use clap::Args;
use kahan_study::{Listed, Systems, list};

use crate::printing::layout::{table, with_headings};
use crate::printing::{Answer, UsageError};

/// Lists the systems of the catalog.
///
/// Each row has the name that other commands take. Systems with variables `x[i]` are chains of any
/// length; they take --sites N.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  kahan list\n  kahan list --json")]
pub(crate) struct List {
    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

impl List {
    pub(crate) fn run(&self) -> Result<Answer, UsageError> {
        Ok(Answer::of(&list(&Systems)?, self.json, text))
    }
}

fn text(listed: &Listed) -> String {
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
    let headings = ["name", "variables", "parameters", "claims", "title"];
    table(&with_headings(headings, systems.chain(families)), 1).join("\n") + "\n"
}
