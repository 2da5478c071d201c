//! The command `kahan show`, which prints the formulas of a system in several notations.

mod plan;
mod sheet;

use clap::Args;
use kahan_algebra::render::macro_block;
use kahan_study::{Show as Question, ShowForm, ShownField, Study};
use serde_json::json;

use super::command_line::{CommandLine, QuestionCommand};
use crate::printing::{Answer, ProgressDisplay, UsageError};
use crate::reading::{Block, Source};

/// Shows the formulas of a system: field, f', A, b, bilinear form, det A, map, Jacobian, claims.
///
/// The map is printed as x~ = x + 2 eps n/d in lowest terms, where eps is half the time step.
/// A(x,eps) is the matrix I - eps f'(x), Q(x,x') the symmetric bilinear form of the quadratic
/// terms; the prime marks its second argument. If the map would have too many terms, det A is shown
/// as a determinant instead.
///
/// --plan shows the operations of the generated code, one per line, and their costs. For more than
/// 500 variables, only the equations are shown.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan show e6
  kahan show euler --latex
  kahan show e9 --param xi=1
  kahan show --field 'xdot = a*y*z; ydot = -x*z; zdot = x*y;' --macro
  kahan show --file field.txt --json
  kahan show e3 --expand                      the generated Rust code
  kahan show e3 --plan                        operations and bytes of the code, step by step
  kahan show --field 'xdot = y; ydot = x^2 - a;' --param a=1 --plan")]
pub(crate) struct Show {
    #[command(flatten)]
    source: Source,

    /// Write the formulas in LaTeX.
    #[arg(long, conflicts_with = "as_macro")]
    latex: bool,

    /// Write a Python script that defines the formulas in SymPy.
    #[arg(long, conflicts_with_all = ["latex", "as_macro"])]
    sympy: bool,

    /// Show every entry of the map's Jacobian.
    #[arg(long, conflicts_with_all = ["as_macro", "plan", "expand"])]
    jacobian: bool,

    /// Print a `kahan!` block to paste into a Rust program.
    #[arg(long = "macro")]
    as_macro: bool,

    /// Show counts of operations, bytes of machine code and compile times of the generated code,
    /// and the operations of a step.
    #[arg(long, conflicts_with_all = ["as_macro", "latex", "sympy"])]
    plan: bool,

    /// Print the Rust code that the macro generates; without a header, as the value of a variable.
    #[arg(long, conflicts_with_all = ["as_macro", "latex", "sympy", "plan"])]
    expand: bool,

    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

impl QuestionCommand for Show {
    type Question = Question;

    fn read_question(&self) -> Result<(Study, Question), UsageError> {
        let form = match self {
            Show { latex: true, .. } => ShowForm::Latex,
            Show { sympy: true, .. } => ShowForm::Sympy,
            Show { plan: true, .. } => ShowForm::Plan,
            // With --json, the answer contains the block anyway, so --macro changes nothing.
            Show { as_macro: true, json: false, .. } => ShowForm::Kahan,
            _ => ShowForm::Text,
        };
        Ok((self.source.study()?, Question { form, jacobian: self.jacobian }))
    }

    fn options(asked: &Question, line: CommandLine) -> CommandLine {
        let line = if asked.jacobian { line.with_flag("--jacobian") } else { line };
        match asked.form {
            ShowForm::Text => line,
            ShowForm::Latex => line.with_flag("--latex"),
            ShowForm::Sympy => line.with_flag("--sympy"),
            ShowForm::Kahan => line.with_flag("--macro"),
            ShowForm::Plan => line.with_flag("--plan"),
        }
    }

    fn run(&self) -> Result<Answer, UsageError> {
        if self.expand {
            return self.expanded();
        }
        let (study, asked) = self.read_question()?;
        let shown = asked.ask(&study, &ProgressDisplay::stages())?;
        Ok(match &shown {
            _ if self.json => Answer::json(&json!(shown)),
            ShownField::Formulas(sheet) if let Some(script) = &sheet.script => {
                Answer::verbatim(script.clone())
            }
            ShownField::Formulas(sheet) if self.latex => Answer::verbatim(sheet::latex(sheet)),
            ShownField::Formulas(sheet) => Answer::text(sheet::text(sheet)),
            ShownField::Block { block, .. } => Answer::text(format!("{block}\n")),
            ShownField::Plan(planned) => Answer::text(plan::text(planned)),
        })
    }
}

impl Show {
    /// Returns the Rust code that the macro generates from the block.
    fn expanded(&self) -> Result<Answer, UsageError> {
        let study = self.source.proved(None)?;
        let core = "::kahan_core".parse().expect("a path");
        let block = if study.fixed().is_empty() {
            study.text().to_owned()
        } else {
            Block::of_text(macro_block(&study.specialised()?), "--macro".to_owned()).text().to_owned()
        };
        let expansion =
            kahan_emit::text(&core, &block).map_err(|why| UsageError::new(format!("--expand: {why}")))?;
        Ok(match self.json {
            true => Answer::json(&json!({ "system": study.name(), "expansion": expansion })),
            false => Answer::verbatim(expansion),
        })
    }
}
