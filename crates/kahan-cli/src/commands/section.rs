//! `kahan section`: where an orbit crosses a plane, or the level of any function.

use std::path::PathBuf;

use clap::Args;
use kahan_draw::answer::jumps;
use kahan_study::{Direction, Section as Question, SectionFound, Study};
use serde_json::{Map, json};

use super::line::Asking;
use crate::printing::{Answer, Broken, Format, Prompt, Refusal, Sink, Table, warn};
use crate::reading::{MOST_OBSERVED, Start, Stepping, one_of, whole};

/// Prints where an orbit crosses a section, as CSV: step n, time t, variables.
///
/// The section is where a formula of the variables, of the claimed integrals, parameters and eps
/// vanishes. A crossing lies between two points of the orbit; it is refined on the curve that the
/// map draws from the first to the second as eps grows from 0, which is as far from the flow as a
/// step is: t is that of the crossing, and n the step that it comes after. A sign change without a
/// zero, as at a pole of the formula or of the map, is a jump: a note counts them, and they are no
/// rows. Steps are those of `kahan orbit` in f64. Where numbers leave the range of f64, the
/// crossings up to there are kept, and the exit status is 1.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan section volterra --eps 0.02 --at 1,2,3 --plane 'x - y' --steps 1e4
  kahan section lv --eps 0.01 --at 1/2,5/3 --plane y-1 --direction falling --steps 1e4 --points 5
  kahan section e6 --eps 0.05 --at 1,2,3 --plane 'x - y' --direction both --steps 1e4 --out e6.csv
  kahan section --field 'xdot = y; ydot = -x;' --eps 0.1 --at 1,0 --plane y-x/2 --steps 99 --json")]
pub(crate) struct Section {
    #[command(flatten)]
    start: Start,

    /// The most steps of the orbit.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(1, MOST_OBSERVED))]
    steps: u64,

    /// What vanishes on the section: z - 27, or x^2 + y^2 - 1.
    #[arg(long, value_name = "EXPR", allow_hyphen_values = true)]
    plane: String,

    /// Which sign changes count: those where the formula grows, falls, or both.
    #[arg(long, value_name = "DIRECTION", value_parser = one_of(&Direction::ALL, |one| one.name().into()), default_value = "rising")]
    direction: Direction,

    #[command(flatten)]
    stepping: Stepping,

    /// Stop after K crossings.
    #[arg(long, value_name = "K", default_value = "100000", allow_hyphen_values = true, value_parser = whole(1, MOST_CROSSINGS))]
    points: usize,

    /// Write the table to this file, which appears when it is complete.
    #[arg(long, value_name = "F.csv")]
    out: Option<PathBuf>,

    /// Print one JSON object: system, variables, steps, ended, ended_step, times, points, jumps.
    #[arg(long)]
    json: bool,
}

/// The most crossings that are kept.
const MOST_CROSSINGS: usize = 1 << 26;

impl Asking for Section {
    type Question = Question;

    fn asked(&self) -> Result<(Study, Question), Refusal> {
        let (study, at, eps) = self.start.study()?;
        let Section { ref plane, steps, direction, points, stepping, .. } = *self;
        let (plane, reembed) = (plane.clone(), stepping.reembed);
        Ok((study, Question { eps, at, steps, plane, direction, points, reembed }))
    }

    /// Writes the crossings; what is left to say is the answer.
    fn run(&self) -> Result<Answer, Refusal> {
        let (study, asked) = self.asked()?;
        let sink = self.out.as_deref().map(Sink::table).transpose()?;
        let found = asked.ask(&study, &Prompt::of("steps"))?;
        let complaint = found.end.is_early().then(|| {
            let (system, next) = (&found.system, found.steps + 1);
            if let Some(why) = &found.why {
                return format!("the orbit of {system} {why}; the crossings up to there are kept");
            }
            format!(
                "the orbit of {system} leaves the range of f64 at step {next}: a pole (det A = 0) or too large numbers; the \
                 crossings up to there are kept"
            )
        });
        if let Some(sink) = sink.or_else(|| (!self.json).then(Sink::standard)) {
            write(&found, sink)?;
        }
        if !self.json {
            jumps(&self.plane, found.jumps).iter().for_each(|note| warn(note));
        }
        Ok(Answer::of(&found, self.json, |_| String::new()).but(complaint))
    }
}

/// Writes a row a crossing.
fn write(found: &SectionFound, sink: Sink) -> Result<(), Broken> {
    let columns: Vec<String> = found.columns().into_iter().map(|column| column.name).collect();
    let head = Map::from_iter([("columns".to_owned(), json!(columns))]);
    let mut table = Table::begin(sink, Format::Csv, &head)?;
    found.rows(0..u64::MAX, &mut table);
    table.written()?;
    table.end(&Map::new())
}
