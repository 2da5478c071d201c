//! The command `kahan section`, which computes the crossings of orbits with a level set.

use std::ops::ControlFlow;
use std::path::PathBuf;

use clap::Args;
use kahan_draw::answer::jumps;
use kahan_study::{Axis, Column, Crossed, Direction, Rows, Section as Question, Study, Values};
use serde_json::{Map, Value, json};

use super::command_line::QuestionCommand;
use crate::printing::{Answer, Format, OutputStream, ProgressDisplay, Table, UsageError, WriteError, warn};
use crate::reading::{MOST_OBSERVED, Rounding, Start, Stepping, Transient, one_of, order, over, whole};

/// Prints where orbits cross a section, as CSV: step n, time t, variables.
///
/// The section is the surface on which a formula vanishes. The formula may contain variables,
/// claimed integrals, parameters and eps. A crossing lies between two points of the orbit. Its
/// place is refined on the curve that the map traces from the first of them to the second as eps
/// grows from 0; this curve is as close to the flow as the step is. The time t is that of the
/// crossing, n the number of the step before it. A sign change without a zero, as at a pole of the
/// formula or of the map, is a jump. Jumps are not printed; a note counts them. Steps are those of
/// `kahan orbit` in f64. If numbers overflow f64, the crossings so far are printed, and the exit
/// status is 1.
///
/// With several initial points, or with --over, each row begins with the number of its initial
/// point, `start`, and the values that vary. The crossings of an orbit are the same as in a run of
/// its own.
#[derive(Args, Debug)]
#[command(mut_group("step", |step| step.required(false)))]
#[command(after_help = "\
Examples:
  kahan section volterra --eps 0.02 --at 1,2,3 --plane 'x - y' --steps 1e4
  kahan section lv --eps 0.01 --at 1/2,5/3 --plane y-1 --direction falling --steps 1e4 --crossings 5
  kahan section e6 --eps 0.05 --at 1,2,3 --plane 'x - y' --direction both --steps 1e4 --out e6.csv
  kahan section lv --eps 0.1 --at 1,1 --over x=1:2:9 --plane y-1 --crossings 3 --order 4")]
pub(crate) struct Section {
    #[command(flatten)]
    start: Start,

    /// The largest number of steps; if only --crossings is given, 10000 for each.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(1, MOST_OBSERVED))]
    steps: Option<u64>,

    /// The formula that vanishes on the section: z - 27, or x^2 + y^2 - 1.
    #[arg(long, value_name = "EXPR", allow_hyphen_values = true, required_unless_present = "maxima")]
    plane: Option<String>,

    /// The section of the maxima of variable X, instead of --plane.
    ///
    /// There its derivative falls through 0.
    #[arg(long, value_name = "X", conflicts_with_all = ["plane", "direction"])]
    maxima: Option<String>,

    /// The sign changes that count: rising, falling or both.
    #[arg(long, value_name = "WAY", hide_possible_values = true, value_parser = one_of(&Direction::ALL, |one| one.name().into()), default_value = "rising")]
    direction: Direction,

    /// Stop an orbit after K crossings.
    #[arg(long, alias = "points", value_name = "K", allow_hyphen_values = true, value_parser = whole(1, MOST_OBSERVED))]
    crossings: Option<u64>,

    #[command(flatten)]
    before: Transient,

    /// The order of the steps and of the crossing times: 2, 4, 6 or 8.
    #[arg(long, value_name = "P", hide_possible_values = true, default_value = "2", value_parser = order())]
    order: u32,

    /// Orbits for each value of a variable, parameter or eps: NAME=FROM:TO:COUNT.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    over: Vec<String>,

    /// With --over: begin each orbit at the last point of the one before it.
    #[arg(long, requires = "over")]
    carry: bool,

    #[command(flatten)]
    stepping: Stepping,

    #[command(flatten)]
    rounding: Rounding,

    /// Write the table to this file, which appears when it is complete.
    #[arg(long, value_name = "F.csv")]
    out: Option<PathBuf>,

    /// Print one JSON object: times and points, or the rows of several orbits.
    #[arg(long)]
    json: bool,
}

impl QuestionCommand for Section {
    type Question = Question;

    fn read_question(&self) -> Result<(Study, Question), UsageError> {
        let axes = self.over.iter().map(|given| over(given)).collect::<Result<Vec<Axis>, _>>()?;
        let (study, mut starts, eps) = if axes.is_empty() {
            let (study, starts, eps) = self.start.starts()?;
            (study, starts, Some(eps))
        } else {
            self.start.starts_over(&axes)?
        };
        let study = study.fusing(self.rounding.fused)?;
        let at = if starts.len() == 1 { starts.swap_remove(0) } else { Vec::new() };
        let (plane, direction) =
            section(&study, self.plane.as_deref(), self.maxima.as_deref(), self.direction)?;
        let Section { steps, crossings, before, order, carry, stepping, .. } = *self;
        let (over, params) = (axes.into_iter().map(Into::into).collect(), Vec::new());
        let reembed = stepping.reembed;
        let asked = Question {
            eps,
            at,
            steps,
            plane,
            direction,
            crossings,
            transient: before.transient,
            order,
            reembed,
            starts,
            params,
            over,
            carry,
        };
        Ok((study, asked))
    }

    /// Writes the crossings. Returns an answer that consists of notes.
    fn run(&self) -> Result<Answer, UsageError> {
        let (study, asked) = self.read_question()?;
        if self.json && self.out.is_none() {
            let found = asked.ask(&study, &ProgressDisplay::of("steps"))?;
            let complaint = complaint(&study, &found.orbits);
            return Ok(Answer::of(&found, true, |_| String::new()).with_complaint(complaint));
        }
        let columns: Vec<String> = asked.columns(&study)?.into_iter().map(|column| column.name).collect();
        let head = Map::from_iter([("columns".to_owned(), json!(columns))]);
        let sink = self.out.as_deref().map(OutputStream::table).transpose()?;
        let watch = ProgressDisplay::beside_rows(sink.is_some(), 0);
        let mut rows = DeferredTable {
            table: None,
            begin: Some((sink.unwrap_or_else(OutputStream::standard), head)),
            broken: None,
        };
        let orbits = asked.find(&study, &mut rows, &watch)?;
        rows.end()?;
        jumps(&asked.plane, orbits.iter().map(|one| one.jumps).sum()).iter().for_each(|note| warn(note));
        Ok(Answer::text(String::new()).with_complaint(complaint(&study, &orbits)))
    }
}

/// Returns the formula of a section, and the direction of the crossings. For maxima of a variable,
/// the formula is the derivative of the variable.
pub(super) fn section(
    study: &Study,
    plane: Option<&str>,
    maxima: Option<&str>,
    direction: Direction,
) -> Result<(String, Direction), UsageError> {
    let Some(variable) = maxima else { return Ok((plane.unwrap_or_default().to_owned(), direction)) };
    let rate = study.rate(variable).map_err(|why| UsageError::new(format!("--maxima: {why}")))?;
    Ok((rate, Direction::Falling))
}

/// Returns a note about the orbits that end early; `None` if all are complete.
fn complaint(study: &Study, orbits: &[Crossed]) -> Option<String> {
    let early: Vec<&Crossed> = orbits.iter().filter(|one| one.end.is_early()).collect();
    let (first, system) = (early.first()?, study.name());
    Some(match &first.why {
        _ if orbits.len() > 1 => format!(
            "{} of {} orbits of {system} end early, at a pole (det A = 0) or beyond the range of f64; the crossings up to \
             there are kept",
            early.len(),
            orbits.len()
        ),
        Some(why) => format!("the orbit of {system} {why}; the crossings up to there are kept"),
        None => format!(
            "the orbit of {system} leaves the range of f64 at step {}: a pole (det A = 0) or too large numbers; the crossings \
             up to there are kept",
            first.steps + 1
        ),
    })
}

/// A table that is opened when its first rows arrive. An error before then leaves no output.
struct DeferredTable {
    table: Option<Table>,
    begin: Option<(OutputStream, Map<String, Value>)>,
    broken: Option<WriteError>,
}

impl DeferredTable {
    fn open_table(&mut self) -> Option<&mut Table> {
        if let Some((sink, head)) = self.begin.take() {
            match Table::begin(sink, Format::Csv, &head) {
                Ok(table) => self.table = Some(table),
                Err(broken) => self.broken = Some(broken),
            }
        }
        self.table.as_mut()
    }

    fn end(mut self) -> Result<(), WriteError> {
        self.open_table();
        self.broken.map_or(Ok(()), Err)?;
        let Some(mut table) = self.table else { return Ok(()) };
        table.written()?;
        table.end(&Map::new())
    }
}

impl Rows for DeferredTable {
    fn block(&mut self, columns: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        self.open_table().map_or(ControlFlow::Break(()), |table| table.block(columns, values))
    }
}
