//! The command `kahan lift`, which turns a field into an equivalent quadratic field.

use std::path::PathBuf;

use clap::Args;
use kahan_algebra::render::{Formulas, macro_block};
use kahan_draw::picture::{PictureOptions, relations};
use kahan_latex::Latex;
use kahan_latex::breaking::{self, PAGE_WIDTH};
use kahan_study::{ClaimShown, LiftFound, RelationFate, RelationFound, Study};

use super::image_options::{ImageOptions, OutFile, usual};
use crate::printing::page::{Page, aligned, paragraph};
use crate::printing::{Answer, UsageError};
use crate::reading::{Source, StepLength};

/// Lifts a field to a quadratic one: functions, quotients and powers become new variables.
///
/// The output is the quadratic field, the definition and the initial value of each new variable,
/// and the relations between the variables with what Kahan's map does to each: preserved exactly,
/// with the formula that the map preserves; or its error stays bounded, decays, drifts linearly or
/// grows, with the rate.
///
/// A mechanical system x' = p, p' = -grad V(x) gets the lift whose map preserves an energy.
/// Otherwise lifts with exactly preserved relations are preferred, then lifts whose relations have
/// errors that do not grow along the orbit from --at over 100 units of time. Other commands lift a
/// field by --lift, as in `kahan orbit --lift …`.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan lift --field 'xdot = v; vdot = -g*sin(x);'
  kahan lift --field 'xdot = v; vdot = -sin(x);' --at 1,0 --eps 0.05
  kahan lift --field \"v' = v - v^3/3 - w + 1/2, w' = (v + 0.7 - 0.8*w)*0.08\" --at 1,0
  kahan lift --field 'xdot = v; vdot = -x^3 + cos(2*t);' --lift=smallest --json
  kahan lift --field 'xdot = v; vdot = -sin(x);' --at 1,0 --out relations.svg
  kahan lift --field 'struct Pendulum { g } xdot = v; vdot = -g*sin(x);' --macro
  kahan orbit --lift --field 'xdot = v; vdot = -sin(x);' --at 1,0 --eps 0.05 --steps 100")]
#[command(mut_arg("eps", |eps| eps.help("Half the time step of that orbit (dt = 2 eps), 0.01 if not given")))]
pub(crate) struct Lift {
    #[command(flatten)]
    source: Source,

    /// The initial point of the orbit that tests the relations, in the original variables.
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    at: Option<String>,

    #[command(flatten)]
    step: StepLength,

    /// Print the lifted field as a `kahan!` block for Rust, with the preserved formulas as claims.
    #[arg(long = "macro")]
    as_macro: bool,

    /// Write the formulas in LaTeX.
    #[arg(long, conflicts_with = "as_macro")]
    latex: bool,

    /// Print one JSON object.
    #[arg(long, conflicts_with_all = ["as_macro", "latex"])]
    json: bool,

    /// Draw the errors of the relations along that orbit into FILE: .svg, .png or .pdf.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,

    #[command(flatten)]
    look: ImageOptions,
}

impl Lift {
    pub(crate) fn run(&self) -> Result<Answer, UsageError> {
        let eps = self.step.half()?;
        let study = self.source.clone().lifted().proved(self.at.as_deref())?;
        if let Some(at) = &self.at {
            crate::reading::point(Some(at), &study)?;
        }
        let found = study.lift_found(eps.map(|eps| eps.to_f64()))?;
        let Some(found) = found else {
            return Err(UsageError::new(
                "--sites: a chain `for i in … { … }` cannot be lifted; write out its equations",
            ));
        };
        if let Some(out) = &self.out {
            let look = PictureOptions::on(self.look.sheet(usual()));
            let picture = relations(&found, &look).ok_or_else(|| {
                UsageError::new("--out draws errors along an orbit: give --at, and a value to each parameter")
            })?;
            OutFile::picture(out)?.put(&picture.drawing, String::new)?;
        }
        Ok(if self.as_macro {
            Answer::verbatim(format!("{}\n", macro_block(study.system())))
        } else if self.latex {
            Answer::verbatim(latex(&study, &found))
        } else {
            Answer::of(&found, self.json, text)
        })
    }
}

fn relation(found: &LiftFound, relation: &RelationFound) -> String {
    let verdict = relation.verdict_asking("give --at");
    format!("{}: {verdict}", found.equation(relation))
}

fn text(found: &LiftFound) -> String {
    let mut page = Page::default();
    let plural = if found.order == 1 { "" } else { "s" };
    page.line(&format!("{}: a quadratic field with {} new variable{plural}", found.system, found.order));
    page.section("field, and what its map keeps", found.field.lines());
    if !found.new.is_empty() {
        page.section(
            "new variables, at the start",
            found.new.iter().map(|new| {
                let meaning = new.expression.as_deref().unwrap_or("0, the work done since the start");
                let value = new.value.map_or_else(String::new, |value| format!(" = {value}"));
                format!("{} = {meaning}{value}", new.name)
            }),
        );
    }
    if !found.relations.is_empty() {
        page.section("relations", found.relations.iter().map(|one| relation(found, one)));
    }
    if let Some(energy) = &found.energy {
        page.section("energy that the map keeps exactly", [energy]);
    }
    page.section("choice", paragraph(&format!("{}; {}.", found.chosen, found.optimality())));
    let is_kept = found.relations.iter().any(|relation| relation.formula.is_some());
    let strays = found.relations.iter().any(|relation| match relation.along {
        Some(RelationFate::Drifts | RelationFate::Grows) => true,
        Some(RelationFate::Bounded) => !is_kept,
        _ => false,
    });
    let projected =
        "`kahan orbit --lift --reembed` holds the relations exactly, by a symmetric projection of each step";
    for note in found.notes.iter().map(String::as_str).chain(strays.then_some(projected)) {
        page.prose(&format!("note: {note}"));
    }
    page.text
}

fn latex(study: &Study, found: &LiftFound) -> String {
    let system = study.system();
    let right = Formulas { field: &system.field, map: None, notation: &Latex }.field();
    let row = |left: String, right: &str| breaking::equation(&left, right, PAGE_WIDTH);
    let name = |name: &String| kahan_algebra::render::Notation::name(&Latex, name);
    let mut page = Page::default();
    page.line(&format!("% {}", found.system));
    let states = found.variables.iter().zip(&right);
    page.display(&aligned(
        states.map(|(state, right)| row(format!("\\dot {{{}}}", name(state)), right)).collect(),
    ));
    let new: Vec<String> =
        found.new.iter().filter_map(|new| Some(row(name(&new.name), new.latex.as_deref()?))).collect();
    if !new.is_empty() {
        page.line("% new variables");
        page.display(&aligned(new));
    }
    for claim in &system.claims {
        page.claim(&ClaimShown::of(system, claim, &Latex));
    }
    page.text
}
