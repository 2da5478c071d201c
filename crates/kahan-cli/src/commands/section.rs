//! `kahan section`: where an orbit crosses a plane, or the level of any function.

use std::ops::ControlFlow;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use kahan_core::observe::{self, Crossing, Direction, Section as Crossings};
use kahan_runtime::{Ended, Follow, Followed, MapAt, RuntimePoint};
use serde_json::{Value, json};

use crate::printing::{Answer, Prompt, Refusal, Sink};
use crate::reading::{Formula, Request, Start, whole};

/// Prints where an orbit crosses a section, as CSV: step n, time t, variables.
///
/// The section is where a formula of the variables, of the claimed integrals, parameters and eps
/// vanishes. A crossing lies between two points of the orbit; it is refined on the curve that the
/// map draws from the first to the second as eps grows from 0, which is as far from the flow as a
/// step is: t is that of the crossing, and n the step that it comes after. Steps are those of
/// `kahan orbit` in f64. Where numbers leave the range of f64, the crossings up to there are kept,
/// and the exit status is 1.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Section {
    #[command(flatten)]
    start: Start,

    /// The most steps of the orbit.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = steps)]
    steps: u64,

    /// What vanishes on the section: z - 27, or x^2 + y^2 - 1.
    #[arg(long, value_name = "EXPR", allow_hyphen_values = true)]
    plane: String,

    /// Which crossings count: those where the formula grows, falls, or both.
    #[arg(long, value_enum, default_value = "rising")]
    direction: Side,

    /// Stop after K crossings.
    #[arg(long, value_name = "K", default_value = "100000", allow_hyphen_values = true, value_parser = points)]
    points: usize,

    /// Write the table to this file, which appears when it is complete.
    #[arg(long, value_name = "F.csv")]
    out: Option<PathBuf>,

    /// Print one JSON object: system, variables, steps, times, points.
    #[arg(long)]
    json: bool,
}

/// The sign with which the formula goes through 0.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Side {
    Rising,
    Falling,
    Both,
}

const EXAMPLES: &str = "\
Examples:
  kahan section volterra --eps 0.02 --at 1,2,3 --plane 'x - y' --steps 1e4
  kahan section lv --eps 0.01 --at 1/2,5/3 --plane y-1 --direction falling --steps 1e4 --points 5
  kahan section e6 --eps 0.05 --at 1,2,3 --plane 'x - y' --direction both --steps 1e4 --out e6.csv
  kahan section --field 'xdot = y; ydot = -x;' --eps 0.1 --at 1,0 --plane y-x/2 --steps 99 --json";

fn steps(text: &str) -> Result<u64, String> {
    whole(text, 1, 1 << 53)
}

fn points(text: &str) -> Result<usize, String> {
    whole(text, 1, 1 << 26)
}

type Point = Crossing<Vec<f64>, f64>;

/// Takes the first crossings, in memory that grows with them: `most` is what a user allows, and far
/// more than there are as a rule.
struct First {
    found: Vec<Point>,
    most: usize,
}

impl observe::Sink<Point> for First {
    type Report = Vec<Point>;

    fn take(&mut self, crossing: Point) {
        self.found.push(crossing);
    }

    fn is_full(&self) -> bool {
        self.found.len() >= self.most
    }

    fn report(self) -> Vec<Point> {
        self.found
    }
}

impl Section {
    /// Writes the crossings; what is left to say is the answer.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let request = self.start.request()?;
        let plane = plane(&request, &self.plane)?;
        let (at, mut x) = request.in_floats()?;
        let direction = match self.direction {
            Side::Rising => Direction::Rising,
            Side::Falling => Direction::Falling,
            Side::Both => Direction::Both,
        };
        let sink = self.out.as_deref().map(|path| Sink::file(path, "--out")).transpose()?;
        let first = First { found: Vec::new(), most: self.points };
        let crossings = Crossings::new(&at, height(&at, &plane), direction, first);
        let progress = Prompt::new(self.steps, "steps");
        let watch = |steps| {
            progress.advance(steps);
            ControlFlow::Continue(())
        };
        let followed = at.observe(&mut x, self.steps, crossings, watch).expect("the start is of the field");
        progress.finish();
        let Followed { report: points, steps, ended } = followed;
        let found = Found { name: &request.name, variables: at.map().field().variables(), points };
        let complaint = (ended == Ended::Range).then(|| {
            format!(
                "the orbit of {} leaves the range of f64 at step {}: a pole (det A = 0) or too large numbers; the crossings up to \
                 there are kept",
                request.name,
                steps + 1
            )
        });
        let answer = match sink {
            Some(sink) => {
                sink.put(found.table())?;
                if self.json { Answer::json(&found.object(steps)) } else { Answer::text(String::new()) }
            }
            None if self.json => Answer::json(&found.object(steps)),
            None => Answer::verbatim(found.table()),
        };
        Ok(Answer { complaint, ..answer })
    }
}

/// The formula that vanishes on a section.
pub(super) fn plane(request: &Request, text: &str) -> Result<Formula, Refusal> {
    let plane = request.formula(text, "--plane")?;
    if plane.last_variable().is_none() {
        return Err(Refusal::new(format!(
            "--plane {text}: the formula is one number everywhere; a section is where a formula of the variables vanishes, as in \
             --plane 'x - 1/2'"
        )));
    }
    Ok(plane)
}

/// How far a point is from a section, as its formula measures it.
pub(super) fn height<'a>(at: &'a MapAt<f64>, plane: &'a Formula) -> impl Fn(&[f64]) -> f64 + 'a {
    let integrals = at.map().field().integrals().len();
    move |x| {
        let mut known: RuntimePoint<f64> = x.iter().copied().collect();
        known.resize(x.len() + integrals, 0.0);
        // The state is as long as the field has variables.
        let _ = at.integrals(x, &mut known[x.len()..]);
        plane.of(&known)
    }
}

/// The crossings of an orbit.
struct Found<'a> {
    name: &'a str,
    variables: &'a [String],
    points: Vec<Point>,
}

impl Found<'_> {
    fn object(&self, steps: u64) -> Value {
        json!({
            "system": self.name,
            "variables": self.variables,
            "steps": steps,
            "times": self.points.iter().map(|crossing| crossing.time).collect::<Vec<_>>(),
            "points": self.points.iter().map(|crossing| crossing.point.to_vec()).collect::<Vec<_>>(),
        })
    }

    fn table(&self) -> String {
        let mut lines = vec![format!("n,t,{}", self.variables.join(","))];
        for crossing in &self.points {
            let numbers = [crossing.time].into_iter().chain(crossing.point.iter().copied());
            let cells: Vec<String> = numbers.map(|number| format!("{number:?}")).collect();
            lines.push(format!("{},{}", crossing.step, cells.join(",")));
        }
        lines.join("\n") + "\n"
    }
}
