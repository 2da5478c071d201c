//! `kahan eval`: every object of a system at one point, in exact or in floating-point numbers.

use clap::Args;
use kahan_algebra::arithmetic::{Exact, Float32, Float64};
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::rational::Rational;
use serde_json::{Map, Value, json};

use crate::numbers::{DoubleDouble, Printable, ScalarKind};
use crate::printing::layout::{labelled, matrix_within, screen_width};
use crate::printing::{Answer, Refusal};
use crate::reading::{Request, Start};
use kahan_algebra::kahan::{RationalMap, TERM_BUDGET};

/// Evaluates every object of a system at a point: field, matrices, Jacobian, claims.
///
/// A value that is undefined at the point is null. At a pole of the map (det A = 0, unless the
/// factor that vanishes was divided out) the rest is printed all the same, and the exit status is
/// 1.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Eval {
    #[command(flatten)]
    start: Start,

    /// The numbers to compute with.
    #[arg(long, value_enum, default_value = "exact")]
    scalar: ScalarKind,

    /// Print one JSON object; exact numbers are strings p/q, floats are numbers (dd: of 32 digits).
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  kahan eval e6 --eps 1/2 --at 1,2,3
  kahan eval e7 --eps -1/2 --at 3/7,11/13,23/47 --param xi=19/17 --json
  kahan eval lv --eps 0.1 --at 1/2,5/3 --scalar f64
  kahan eval lv --eps 0.1 --at 1/2,5/3 --scalar dd
  kahan eval --field 'xdot = y; ydot = 6*x^2 - a;' --param a=2 --eps 1e-2 --at 0,1";

/// The evaluated objects, and what to complain of.
struct Evaluated {
    objects: Value,
    complaint: Option<String>,
}

impl Eval {
    /// The object of all values; a complaint at a pole.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let request = self.start.request()?;
        let Evaluated { objects, complaint } = match self.scalar {
            ScalarKind::Exact => request.evaluate(&Exact),
            ScalarKind::F64 => request.evaluate(&Float64),
            ScalarKind::F32 => request.evaluate(&Float32),
            ScalarKind::Dd => request.evaluate(&DoubleDouble),
        }?;
        let answer = if self.json { Answer::json(&objects) } else { Answer::text(readable(&objects)) };
        Ok(Answer { complaint, ..answer })
    }
}

impl Request {
    fn evaluate<A: Printable>(&self, arithmetic: &A) -> Result<Evaluated, Refusal> {
        let round = |values: &[Rational]| values.iter().map(A::round).collect::<Vec<_>>();
        let point = Point {
            state: round(&self.point.state),
            parameters: round(&self.point.parameters),
            eps: A::round(&self.point.eps),
        };
        let values = Interpreter::new(&self.system)
            .evaluate(arithmetic, &point)
            .map_err(|_| self.undefined_field())?;
        let next = values.next.filter(|next| next.iter().all(A::is_finite));
        let is_singular = arithmetic.is_zero(&values.det_matrix);
        let complaint = next.is_none().then(|| self.undefined_step(is_singular));
        let jacobian = values.jacobian.filter(|_| next.is_some());
        let det_jacobian = values.det_jacobian.filter(|_| next.is_some());

        let vector = |values: &Vec<A::Value>| values.iter().map(A::json).collect::<Value>();
        let rows = |rows: &Vec<Vec<A::Value>>| rows.iter().map(vector).collect::<Value>();
        let symbols = &self.system.field.symbols;
        let parameters = symbols.parameters.iter().cloned().zip(point.parameters.iter().map(A::json));
        let integrals =
            values.integrals.iter().map(|(name, value)| (name.clone(), json!(value.as_ref().map(A::json))));
        let brackets =
            values.brackets.iter().map(|(name, value)| (name.clone(), json!(value.as_ref().map(rows))));
        let objects = json!({
            "system": self.name,
            "variables": symbols.states,
            "parameters": parameters.collect::<Map<_, _>>(),
            "eps": A::json(&point.eps),
            "x": vector(&point.state),
            "field": vector(&values.field),
            "field_jacobian": rows(&values.field_jacobian),
            "A": rows(&values.matrix),
            "b": vector(&values.rhs),
            "det_A": A::json(&values.det_matrix),
            "x_next": next.as_ref().map(vector),
            "jacobian": jacobian.as_ref().map(rows),
            "det_jacobian": det_jacobian.as_ref().map(A::json),
            "integrals": integrals.collect::<Map<_, _>>(),
            "density": values.density.flatten().as_ref().map(A::json),
            "brackets": brackets.collect::<Map<_, _>>(),
        });
        Ok(Evaluated { objects, complaint })
    }

    fn undefined_step(&self, is_singular: bool) -> String {
        let (name, place) = (&self.name, self.place::<Exact>(&self.point.state));
        if is_singular && RationalMap::of(&self.system.field).is_none() {
            format!(
                "det A = 0 at {place}, which counts as a pole of the map of {name}: its closed form is beyond the budget of \
                 {TERM_BUDGET} terms, so it is not reduced, and it may have a value there"
            )
        } else if is_singular {
            format!(
                "the map of {name} has a pole at {place}: det A = 0 there, and the next point has no value"
            )
        } else {
            format!(
                "the next point of {name} is beyond the range of the scalar at {place}; try --scalar exact"
            )
        }
    }
}

/// The same object as lines: a label, then a value, a vector or a matrix.
fn readable(objects: &Value) -> String {
    let mut lines = Vec::new();
    for (key, value) in objects.as_object().into_iter().flatten() {
        match (key.as_str(), value) {
            ("variables", _) => {}
            ("parameters" | "integrals" | "brackets", Value::Object(named)) => {
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
    /// The columns of the labels.
    const LABELS: usize = 16;
    let cell = |value: &Value| match value {
        Value::Null => "undefined".to_owned(),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    match value {
        Value::Array(items) if items.iter().any(Value::is_array) => {
            let rows = items.iter().filter_map(Value::as_array);
            let rows: Vec<Vec<String>> = rows.map(|row| row.iter().map(cell).collect()).collect();
            beside_or_below(label, &rows, LABELS)
        }
        Value::Array(items) => {
            let items: Vec<String> = items.iter().map(cell).collect();
            labelled(label, &format!("({})", items.join(", ")), LABELS)
        }
        single => labelled(label, &cell(single), LABELS),
    }
}

/// A matrix beside its label, or below it where that spares breaks.
fn beside_or_below(label: &str, rows: &[Vec<String>], labels: usize) -> Vec<String> {
    let room = screen_width().saturating_sub(labels + 2);
    let beside = matrix_within(rows, '[', ']', room);
    if label.chars().count() <= labels
        && beside.len() == rows.len()
        && beside.iter().all(|line| line.chars().count() <= room)
    {
        let labelled = std::iter::once(label).chain(std::iter::repeat("")).zip(&beside);
        return labelled.map(|(label, line)| format!("{label:<labels$}  {line}")).collect();
    }
    let below = matrix_within(rows, '[', ']', screen_width().saturating_sub(2));
    std::iter::once(label.to_owned()).chain(below.iter().map(|line| format!("  {line}"))).collect()
}
