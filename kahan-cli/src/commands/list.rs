//! `kahan list`: the catalog in one table.

use clap::Args;
use kahan_systems::registry::all;
use serde_json::{Value, json};

use crate::printing::layout::table;
use crate::printing::{Answer, Refusal};
use crate::reading::Block;

/// Lists the systems of the catalog: name, variables, parameters, number of claims, title.
#[derive(Args, Debug)]
#[command(after_help = "Examples:\n  kahan list\n  kahan list --json")]
pub(crate) struct List {
    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

impl List {
    /// The table, or `systems`: [{`name`, `type`, `title`, `variables`, `parameters`, `claims`}].
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let mut rows =
            vec![["name", "variables", "parameters", "claims", "title"].map(str::to_owned).to_vec()];
        let mut objects: Vec<Value> = Vec::new();
        for entry in all() {
            let system = Block::of_catalog(entry).unproved_system()?;
            let symbols = &system.field.symbols;
            let claims: Vec<&str> = system.claims.iter().map(|claim| claim.name.text.as_str()).collect();
            rows.push(vec![
                entry.command.to_owned(),
                symbols.states.join(","),
                symbols.parameters.join(","),
                claims.len().to_string(),
                entry.title.to_owned(),
            ]);
            objects.push(json!({
                "name": entry.command,
                "type": entry.type_name,
                "title": entry.title,
                "variables": symbols.states,
                "parameters": symbols.parameters,
                "claims": claims,
            }));
        }
        if self.json {
            return Ok(Answer::json(&json!({ "systems": objects })));
        }
        Ok(Answer::text(table(&rows, 1).join("\n") + "\n"))
    }
}
