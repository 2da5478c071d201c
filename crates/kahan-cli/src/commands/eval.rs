//! The command `kahan eval`: the formulas of a system at a point, in exact numbers or floats.

use std::iter;

use clap::Args;
use kahan_algebra::kahan::TERM_BUDGET;
use kahan_study::numbers::ScalarKind;
use kahan_study::{Evaluate, NoStep, Study, Unwatched};
use serde_json::{Value, json};

use super::command_line::QuestionCommand;
use crate::printing::layout::{beside_label, labelled, matrix, screen_width};
use crate::printing::{Answer, UsageError, joined};
use crate::reading::{Start, scalar};

/// Evaluates all formulas of a system at a point: field, matrices, map, Jacobian, claims.
///
/// A value that is undefined at the point is null. At a pole of the map (det A = 0, unless the
/// factor that vanishes cancels in the map) all other values are printed, and the exit status is 1.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan eval e6 --eps 1/2 --at 1,2,3
  kahan eval e7 --eps -1/2 --at 3/7,11/13,23/47 --param xi=19/17 --json
  kahan eval lv --eps 0.1 --at 1/2,5/3 --scalar f64
  kahan eval lv --eps 0.1 --at 1/2,5/3 --scalar dd
  kahan eval --field 'xdot = y; ydot = 6*x^2 - a;' --param a=2 --eps 1e-2 --at 0,1")]
pub(crate) struct Eval {
    #[command(flatten)]
    start: Start,

    /// The number type.
    #[arg(long, value_parser = scalar(), default_value = "exact")]
    scalar: ScalarKind,

    /// Print one JSON object: exact numbers as strings p/q, floats as numbers (dd: 32 digits).
    #[arg(long)]
    json: bool,
}

impl QuestionCommand for Eval {
    type Question = Evaluate;

    fn read_question(&self) -> Result<(Study, Evaluate), UsageError> {
        let (study, at, eps) = self.start.study()?;
        Ok((study, Evaluate { eps, at, scalar: self.scalar }))
    }

    fn run(&self) -> Result<Answer, UsageError> {
        let (study, asked) = self.read_question()?;
        let values = asked.ask(&study, &Unwatched)?;
        let complaint = values.no_step.map(|why| no_step(&study, &asked, why));
        Ok(Answer::of(&json!(values), self.json, readable).with_complaint(complaint))
    }
}

fn no_step(study: &Study, asked: &Evaluate, why: NoStep) -> String {
    let (name, place) = (study.name(), study.place(&asked.at, &asked.eps));
    match why {
        NoStep::Unreduced => unreduced_note(name, &place),
        NoStep::Pole => format!(
            "the map of {name} has a pole at {place}: det A = 0 there, and the next point has no value"
        ),
        NoStep::Range => format!(
            "the next point of {name} is beyond the range of the scalar at {place}; try --scalar exact"
        ),
    }
}

/// Returns the note for det A = 0 in a map that is too large to reduce: this counts as a pole.
pub(super) fn unreduced_note(name: &str, place: &str) -> String {
    format!(
        "det A = 0 at {place}, which counts as a pole of the map of {name}: its closed form is beyond the budget of {TERM_BUDGET} \
         terms, so it is not reduced, and it may have a value there"
    )
}

/// Formats the JSON object as text: each line has a label, then a value, a vector or a matrix.
fn readable(objects: &Value) -> String {
    let mut lines = Vec::new();
    for (key, value) in objects.as_object().into_iter().flatten() {
        match (key.as_str(), value) {
            ("variables", _) => {}
            ("parameters" | "integrals" | "brackets" | "drifts", Value::Object(named)) => {
                let kind = key.trim_end_matches('s');
                lines.extend(
                    named.iter().flat_map(|(name, value)| lines_of(&format!("{kind} {name}"), value)),
                );
            }
            _ => lines.extend(lines_of(key, value)),
        }
    }
    lines.join("\n") + "\n"
}

fn lines_of(label: &str, value: &Value) -> Vec<String> {
    const LABEL_WIDTH: usize = 16;
    let cell = |value: &Value| match value {
        Value::Null => "undefined".to_owned(),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    match value {
        Value::Array(items) if items.iter().any(Value::is_array) => {
            let rows = items.iter().filter_map(Value::as_array);
            let rows: Vec<Vec<String>> = rows.map(|row| row.iter().map(cell).collect()).collect();
            beside_or_below(label, &rows, LABEL_WIDTH)
        }
        Value::Array(items) => {
            labelled(label, &format!("({})", joined(items.iter().map(cell), ", ")), LABEL_WIDTH)
        }
        single => labelled(label, &cell(single), LABEL_WIDTH),
    }
}

/// Returns a matrix beside its label, or below the label if it does not fit beside it.
fn beside_or_below(label: &str, rows: &[Vec<String>], labels: usize) -> Vec<String> {
    let length = |text: &str| text.chars().count();
    let room = screen_width().saturating_sub(labels + 2);
    let lines = matrix(rows, '[', ']', room);
    let fits = lines.len() == rows.len() && lines.iter().all(|line| length(line) <= room);
    if length(label) <= labels && fits {
        return beside_label(label, lines, labels);
    }
    let below = matrix(rows, '[', ']', screen_width().saturating_sub(2));
    iter::once(label.to_owned()).chain(below.iter().map(|line| format!("  {line}"))).collect()
}
