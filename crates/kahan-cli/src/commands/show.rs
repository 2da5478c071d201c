//! `kahan show`: the formulas of a system as text, as LaTeX, or as the block of the macro; or the
//! plan of its code.

mod plan;
mod sheet;

use clap::Args;
use kahan_algebra::render::{Notation, Text, macro_block};
use kahan_algebra::system::System;
use kahan_emit::rust;
use kahan_latex::Latex;
use serde_json::json;

use crate::printing::{Answer, Refusal};
use crate::reading::{Block, Source};
use plan::PlanSheet;
use sheet::Sheet;

/// Shows the formulas of a system: field, f', A, b, bilinear form, det A, map, Jacobian, claims.
///
/// The map is x~ = x + 2 eps n/d in lowest terms, where eps is half the time step; a prime marks
/// the second argument of the bilinear form Q(x,x'). For a field whose map is beyond the budget of
/// terms, det A is shown as a determinant. With --plan: what the generated code computes, in
/// straight lines, and what that costs.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Show {
    #[command(flatten)]
    source: Source,

    /// Write the formulas in LaTeX.
    #[arg(long, conflicts_with = "as_macro")]
    latex: bool,

    /// Print the block of `kahan!`, ready to paste.
    #[arg(long = "macro")]
    as_macro: bool,

    /// Show the operations, the machine code and the compile time of everything that is generated,
    /// and the step's plan.
    #[arg(long, conflicts_with_all = ["as_macro", "latex"])]
    plan: bool,

    /// Print the Rust that the macro makes of the block; without a header, as the value of a
    /// variable.
    #[arg(long, conflicts_with_all = ["as_macro", "latex", "plan"])]
    expand: bool,

    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  kahan show e6
  kahan show euler --latex
  kahan show e9 --param xi=1
  kahan show --field 'xdot = a*y*z; ydot = -x*z; zdot = x*y;' --macro
  kahan show --file field.txt --json
  kahan show e3 --expand                      what the macro makes of it
  kahan show e3 --plan                        operations, bytes and the step in straight lines
  kahan show --field 'xdot = y; ydot = x^2 - a;' --param a=1 --plan";

impl Show {
    /// The formulas of the system.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let block = self.source.required_block()?;
        let system = block.system()?;
        let name = block.name(&system);
        let system = self.source.specialised(system, &name)?;
        if self.plan {
            let sheet = PlanSheet::of(name, &system);
            return Ok(if self.json { Answer::json(&sheet.json()) } else { Answer::text(sheet.text()) });
        }
        if self.expand {
            let expansion = self.expansion(&block, &system)?;
            return Ok(match self.json {
                true => Answer::json(&json!({ "system": name, "expansion": expansion })),
                false => Answer::verbatim(expansion),
            });
        }
        if self.as_macro && !self.json {
            return Ok(Answer::text(macro_block(&system) + "\n"));
        }
        let notation: &dyn Notation = if self.latex { &Latex } else { &Text };
        let sheet = Sheet::of(&block, &system, notation);
        Ok(match (self.json, self.latex) {
            (true, _) => Answer::json(&sheet.json()),
            (false, true) => Answer::verbatim(sheet.latex()),
            (false, false) => Answer::text(sheet.text()),
        })
    }
}

impl Show {
    /// The block as the macro expands it; with values of parameters, the block that `--macro`
    /// prints.
    fn expansion(&self, block: &Block, system: &System) -> Result<String, Refusal> {
        let core = "::kahan_core".parse().expect("a path");
        let expanded = if self.source.has_parameters() {
            rust::text(&core, Block::of_text(macro_block(system), "--macro".to_owned()).text())
        } else {
            rust::text(&core, block.text())
        };
        expanded.map_err(|why| {
            Refusal::new(format!(
                "--expand: the text is not made of Rust's tokens, so no macro can read it: {why}"
            ))
        })
    }
}
