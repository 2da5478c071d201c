//! `kahan list`: the catalog in one table.

use clap::Args;
use kahan_systems::lattices::ALL;
use kahan_systems::registry::all;
use serde_json::{Value, json};

use crate::printing::layout::table;
use crate::printing::{Answer, Refusal};
use crate::reading::Block;

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
    /// The table, or `systems`: [{`name`, `type`, `title`, `variables`, `parameters`, `claims`}],
    /// and `families` likewise, with `arrays` in the place of `variables`.
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
        let mut families: Vec<Value> = Vec::new();
        for entry in &ALL {
            let family = Block::of_family(entry).family(entry.command)?;
            let sums = family.integrals.iter().chain(&family.hamiltonian);
            let claims: Vec<&str> = sums.map(|sum| sum.name.text.as_str()).collect();
            let at_site = |names: &[String]| names.iter().map(|name| format!("{name}[i]")).collect();
            let arrays: Vec<String> = at_site(&family.arrays);
            let parameters = [family.parameters.clone(), at_site(&family.site_parameters)].concat();
            rows.push(vec![
                entry.command.to_owned(),
                arrays.join(","),
                parameters.join(","),
                claims.len().to_string(),
                entry.title.to_owned(),
            ]);
            families.push(json!({
                "name": entry.command,
                "type": family.name(),
                "title": entry.title,
                "arrays": family.arrays,
                "parameters": parameters,
                "claims": claims,
            }));
        }
        if self.json {
            return Ok(Answer::json(&json!({ "systems": objects, "families": families })));
        }
        Ok(Answer::text(table(&rows, 1).join("\n") + "\n"))
    }
}
