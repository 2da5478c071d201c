//! `kahan periodic`: cycles of the map, how stable they are, and where they go when something
//! changes.

use std::path::PathBuf;

use clap::Args;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_core::periodic::{Branch, Change, PeriodicPoint, Stability, branch, periodic_point};
use kahan_runtime::{Field, MapAt, RationalCycle};
use serde_json::{Value, json};

use crate::plot::{Format, Mark, Plot, Series, Sheet, Theme};
use crate::printing::layout::{Rows, table};
use crate::printing::{Answer, Prompt, Refusal, Sink};
use crate::reading::{Range, Request, Spacing, Start, whole};

/// Finds a periodic point near a first one: its multipliers, and how it changes.
///
/// Newton's method with the exact Jacobian takes all points of the cycle as unknowns; where cycles
/// come in families, as those of integrable maps do, it goes to the nearest. Multipliers are the
/// eigenvalues of the derivative of the map over the period; `family` counts the directions that it
/// leaves as they are. Where the points are fractions of a few digits, the cycle is proved exactly,
/// and its stability is decided by the exact characteristic polynomial of that derivative.
///
/// --over follows the cycle along a range of eps or of a parameter, round folds, and tells where
/// multipliers go through the unit circle; there --eps or --param gives the value where the range
/// begins, and may be left out. The table has about as many rows as the range has values: more
/// round a fold, fewer where points move far, and the last one may lie beyond the range. --out
/// writes it as CSV, or draws it. The exit status is 1 where no cycle is found.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
// ε may be what changes.
#[command(mut_arg("eps", |eps| eps.required(false)))]
pub(crate) struct Periodic {
    #[command(flatten)]
    start: Start,

    /// A multiple of the period; the smallest period is told.
    #[arg(long, value_name = "K", default_value = "1", allow_hyphen_values = true, value_parser = period)]
    period: usize,

    /// What changes, a parameter or eps: NAME=FROM:TO:COUNT, or :+STEP.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    over: Option<String>,

    /// Write the branch to this file: a table, F.csv, or a picture of the first variable, F.svg or
    /// F.png.
    #[arg(long, value_name = "F", requires = "over")]
    out: Option<PathBuf>,

    /// Print one JSON object: period, points, residual, multipliers, stability, family, exact,
    /// branch.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  kahan periodic lv --eps 1/10 --at 0.9,1.1
  kahan periodic henon-heiles --param a=1 --param b=1 --param c=-1 --eps 0.1 --at 0,0.9,0,0
  kahan periodic --field 'xdot = x^2 + x + 1;' --eps 1 --at 0.2 --period 3
  kahan periodic --field 'xdot = a - x^2;' --param a=1 --eps 0.1 --at 1 --over a=1:-1:41 --out a.svg";

fn period(text: &str) -> Result<usize, String> {
    whole(text, 1, 200)
}

/// The most unknowns of Newton's method: beyond, a step takes minutes.
const MOST_UNKNOWNS: usize = 600;

impl Periodic {
    /// The cycle, and its branch.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        // So many steps were one value more.
        let range = self.over.as_deref().map(|over| Range::over(over, |steps| Spacing::Count(steps + 1)));
        let range = range.transpose()?;
        let format = match &self.out {
            Some(out) if out.extension().is_some_and(|ending| ending == "csv") => None,
            Some(out) => Some(Format::of(out)?),
            None => None,
        };
        let request = self.start.request_over(range.as_slice())?;
        let unknowns = self.period * request.point.state.len();
        if unknowns > MOST_UNKNOWNS {
            return Err(Refusal::new(format!(
                "--period {}: a cycle of {unknowns} numbers is beyond the {MOST_UNKNOWNS} that Newton's method is given",
                self.period
            )));
        }
        let family = Family::of(&request, range.as_ref())?;
        let sink = self.out.as_deref().map(|path| Sink::file(path, "--out")).transpose()?;
        let begin = range.as_ref().map_or(f64::NAN, |range| range.value(0).to_f64());
        let start: Vec<f64> = request.point.state.iter().map(Rational::to_f64).collect();
        let cycle = match periodic_point(&family.at(begin), &start, self.period) {
            Ok(cycle) => cycle,
            Err(why) => {
                let complaint = format!("{}: no cycle was found: {why}", request.name);
                return Ok(Answer { complaint: Some(complaint), ..Answer::text(String::new()) });
            }
        };
        let found = Found {
            exact: family.exact(&cycle),
            branch: range.as_ref().map(|range| family.branch(&cycle, range)),
            cycle,
            request: &request,
            name: range.as_ref().map(|range| range.name.to_owned()),
        };
        if let Some(sink) = sink {
            let sheet = Sheet { pixels: (960, 720), theme: Theme::Viewer };
            match format {
                Some(format) => sink.put(found.plot().drawing().file(format, &sheet)?)?,
                None => sink.put(found.csv())?,
            }
        }
        Ok(if self.json { Answer::json(&found.object()) } else { Answer::text(found.text()) })
    }
}

/// The map at each value of what changes.
struct Family<'a> {
    request: &'a Request,
    field: Field,
    /// The index of the parameter that changes; `None` for ε, or for nothing.
    parameter: Option<usize>,
    changes: bool,
}

impl<'a> Family<'a> {
    fn of(request: &'a Request, range: Option<&Range<'_>>) -> Result<Self, Refusal> {
        let field = Field::of(&request.system);
        // A mistake in what is given is told before the search.
        request.in_floats()?;
        let names = field.parameters();
        let parameter = match range {
            Some(range) if range.name != "eps" => {
                let place = names.iter().position(|name| name == range.name).ok_or_else(|| {
                    let known: Vec<&str> = names.iter().map(String::as_str).chain(["eps"]).collect();
                    Refusal::new(format!(
                        "--over: `{}` is no parameter of {}; there is {}",
                        range.name,
                        request.name,
                        known.join(", ")
                    ))
                })?;
                Some(place)
            }
            _ => None,
        };
        Ok(Family { request, field, parameter, changes: range.is_some() })
    }

    /// The map where what changes has this value; where the field divides by zero, that of no
    /// value.
    fn at(&self, value: f64) -> MapAt<f64> {
        let mut parameters = self.request.point.parameters.clone();
        if let Some(place) = self.parameter {
            parameters[place] = Rational::from_f64(value).unwrap_or_default();
        }
        let eps = match (self.changes, self.parameter) {
            (true, None) => value,
            _ => self.request.point.eps.to_f64(),
        };
        let defined = self.field.with(self.field.parameters().iter().zip(&parameters));
        match defined {
            Ok(map) => map.at(eps),
            // The request has seen to it that there is a map at its own values.
            Err(_) => self.own().at(f64::NAN),
        }
    }

    /// The branch that begins with a cycle.
    fn branch(&self, cycle: &PeriodicPoint, range: &Range<'_>) -> Branch {
        let (ends, steps) = (range.ends().map(|end| end.to_f64()), range.count() - 1);
        let map = |value| self.at(value).by(self.parameter);
        // A branch that winds has more.
        let progress = Prompt::new(steps as u64, "cycles");
        let branch = branch(map, cycle, ends, steps, |_| progress.advance(1));
        progress.finish();
        branch
    }

    /// The map at the values that were given.
    fn own(&self) -> kahan_runtime::Map {
        let given = self.field.parameters().iter().zip(&self.request.point.parameters);
        self.field.with(given).expect("the request is defined")
    }

    /// The cycle over ℚ, where nothing changes.
    fn exact(&self, cycle: &PeriodicPoint) -> Option<RationalCycle> {
        if self.changes { None } else { self.own().rational_cycle(&self.request.point.eps, cycle) }
    }
}

/// What was found.
struct Found<'a> {
    request: &'a Request,
    cycle: PeriodicPoint,
    exact: Option<RationalCycle>,
    branch: Option<Branch>,
    /// What changes along the branch.
    name: Option<String>,
}

impl Found<'_> {
    fn variables(&self) -> &[String] {
        &self.request.system.field.symbols.states
    }

    fn object(&self) -> Value {
        let texts = |point: &Vec<Rational>| point.iter().map(ToString::to_string).collect::<Vec<_>>();
        let exact = |exact: &RationalCycle| {
            json!({
                "points": exact.points.iter().map(texts).collect::<Vec<_>>(),
                "polynomial": polynomial(exact),
                "stability": word(exact.stability),
            })
        };
        let cycle = |cycle: &PeriodicPoint| {
            json!({
                "period": cycle.points.len(),
                "points": cycle.points,
                "residual": cycle.residual,
                "multipliers": cycle.multipliers.iter().map(|one| [one.re, one.im]).collect::<Vec<_>>(),
                "stability": word(cycle.stability()),
                "family": cycle.family,
            })
        };
        let mut object = cycle(&self.cycle);
        object["system"] = json!(self.request.name);
        object["variables"] = json!(self.variables());
        object["exact"] = self.exact.as_ref().map_or(Value::Null, exact);
        if let Some(branch) = &self.branch {
            let points = branch.points.iter().map(|point| {
                let mut object = cycle(&point.cycle);
                object["parameter"] = json!(point.parameter);
                object
            });
            let turns = branch
                .turns
                .iter()
                .map(|turn| json!({ "change": change(turn.change), "parameter": turn.parameter }));
            object["branch"] = json!({
                "over": self.name,
                "points": points.collect::<Vec<_>>(),
                "turns": turns.collect::<Vec<_>>(),
                "cut": branch.is_cut,
            });
        }
        object
    }

    fn text(&self) -> String {
        let cycle = &self.cycle;
        let mut lines = vec![
            format!("period       {}", cycle.points.len()),
            format!("stability    {}", word(cycle.stability())),
            format!("multipliers  {}", multipliers(cycle)),
            format!(
                "family       {}",
                match cycle.family {
                    0 => "it stands alone".to_owned(),
                    1 => "1 direction leads to neighbours of the same period".to_owned(),
                    directions => format!("{directions} directions lead to neighbours of the same period"),
                }
            ),
            format!("residual     {:.1e}", cycle.residual),
            String::new(),
        ];
        let heading = ["n".to_owned()].into_iter().chain(self.variables().iter().cloned()).collect();
        let points = cycle.points.iter().enumerate().map(|(n, point)| {
            [n.to_string()].into_iter().chain(point.iter().map(|x| format!("{x:?}"))).collect()
        });
        lines.extend(table(&[heading].into_iter().chain(points).collect::<Rows>(), 1));
        if let Some(exact) = &self.exact {
            let points = exact.points.iter().map(|point| {
                format!("({})", point.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "))
            });
            lines.push(String::new());
            lines.push(format!("proved exactly: {}", points.collect::<Vec<_>>().join(" → ")));
            lines.push(format!(
                "multipliers are the roots of {}: {}",
                polynomial(exact),
                word(exact.stability)
            ));
        }
        if let Some(branch) = &self.branch {
            lines.push(String::new());
            lines.extend(table(&self.rows(branch), 1));
            lines.push(String::new());
            let name = self.name.as_deref().unwrap_or_default();
            lines.extend(
                branch
                    .turns
                    .iter()
                    .map(|turn| format!("at {name} = {:.10}: {}", turn.parameter, change(turn.change))),
            );
            if branch.is_cut {
                lines.push(
                    "the branch ends before the range does: at a pole, where cycles come together, or since it winds"
                        .to_owned(),
                );
            }
        }
        lines.join("\n").trim_end().to_owned() + "\n"
    }

    /// A row a step of the branch, below headings.
    fn rows(&self, branch: &Branch) -> Rows {
        let head = [self.name.clone().unwrap_or_default()];
        let tail = ["stability", "multipliers"].map(str::to_owned);
        let heading = head.into_iter().chain(self.variables().iter().cloned()).chain(tail).collect();
        let rows = branch.points.iter().map(|point| {
            let first = point.cycle.points[0].iter().map(|x| format!("{x:.8}"));
            let tail = [word(point.cycle.stability()).to_owned(), multipliers(&point.cycle)];
            [format!("{:.8}", point.parameter)].into_iter().chain(first).chain(tail).collect()
        });
        [heading].into_iter().chain(rows).collect()
    }

    /// All points of each cycle, one behind the other.
    fn csv(&self) -> String {
        let name = self.name.as_deref().unwrap_or_default();
        let mut text = format!("{name},n,{},stability\n", self.variables().join(","));
        for point in self.branch.iter().flat_map(|branch| &branch.points) {
            for (n, x) in point.cycle.points.iter().enumerate() {
                let numbers: Vec<String> = x.iter().map(|x| format!("{x:?}")).collect();
                text += &format!(
                    "{:?},{n},{},{}\n",
                    point.parameter,
                    numbers.join(","),
                    word(point.cycle.stability())
                );
            }
        }
        text
    }

    /// The first variable of each point over what changes: stable cycles and others apart.
    fn plot(&self) -> Plot {
        let points = |wanted: &dyn Fn(Stability) -> bool| -> Vec<(f64, f64)> {
            let points = self.branch.iter().flat_map(|branch| &branch.points);
            let shown = points.filter(|point| wanted(point.cycle.stability()));
            shown.flat_map(|point| point.cycle.points.iter().map(|x| (point.parameter, x[0]))).collect()
        };
        let is_stable = |stability| matches!(stability, Stability::Attracting | Stability::Neutral);
        let name = self.name.as_deref().unwrap_or_default();
        let series = vec![
            Series::new("attracting or neutral", 1, Mark::Dots, points(&is_stable)),
            Series::new("repelling or saddle", 2, Mark::Dots, points(&|stability| !is_stable(stability))),
        ];
        let description = format!("Cycles of {} over {name}", self.request.name);
        Plot::around(&description, [name, &self.variables()[0]], series)
    }
}

fn word(stability: Stability) -> &'static str {
    match stability {
        Stability::Attracting => "attracting",
        Stability::Repelling => "repelling",
        Stability::Saddle => "saddle",
        Stability::Neutral => "neutral",
    }
}

/// The characteristic polynomial, in z.
fn polynomial(exact: &RationalCycle) -> String {
    let symbols = Symbols { states: vec!["z".to_owned()], parameters: Vec::new() };
    Text.polynomial(&symbols, &exact.polynomial)
}

fn change(change: Change) -> &'static str {
    match change {
        Change::Fold => "fold, two cycles meet",
        Change::ThroughOne => "a multiplier goes through 1",
        Change::ThroughMinusOne => "a multiplier goes through -1, the period may double",
        Change::ThroughCircle => "a pair of multipliers goes through the unit circle",
    }
}

fn multipliers(cycle: &PeriodicPoint) -> String {
    let texts = cycle.multipliers.iter().map(|one| match one.im {
        0.0 => format!("{:.6}", one.re),
        im => format!("{:.6}{}{:.6}i", one.re, if im < 0.0 { "-" } else { "+" }, im.abs()),
    });
    texts.collect::<Vec<_>>().join("  ")
}
