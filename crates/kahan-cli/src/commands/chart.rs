//! The command `kahan chart`, which draws an observable of orbits over one or two quantities.

mod rows;

use std::collections::HashMap;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, TypedValueParser};
use clap::{Arg, Args, Command};
use kahan_draw::picture::{Chart as PictureRequest, PictureOptions, chart};
use kahan_study::{Axis, ColourColumn, Observable, Observe, Over, Question, Study, StudyError};
use serde_json::{Value, json};

use super::command_line::{CommandLine, QuestionCommand};
use super::dynamics::radius;
use super::image_options::{ImageOptions, OutFile, usual};
use crate::printing::{Answer, ProgressDisplay, UsageError, csv};
use crate::reading::{self, Rounding, Start, Stepping, Transient, observable, whole};

use rows::Rows;

/// Charts a property of orbits over one or two quantities.
///
/// --over, given once or twice, names what varies: the initial value of a variable, a parameter, or
/// eps. All else is fixed by --at, --param and --eps. For each value, or pair of values, an orbit
/// is computed in f64, with the same number of steps for all, and an observable is measured along
/// it. With one range, the result is a curve; with two, the colour of a cell around the values. The
/// curve has a gap, and the cell stays empty, if the orbit overflows or exceeds --escape; with
/// --color escape, if it does neither. The legend counts these orbits. Results do not depend on the
/// number of threads. The file is a picture, or a table with a row per orbit: the value, how the
/// orbit ended, and after how many steps.
///
/// SALI and drift are shown as logarithms to base 10. Chaotic orbits have a small SALI, down to
/// -16, or a large FLI, MEGNO or Lyapunov exponent. On regular orbits SALI falls slowly or not at
/// all, FLI grows like log n, MEGNO tends to 2, and the exponent to 0. `kahan help dynamics`
/// defines these indicators.
///
/// A range is NAME=FROM:TO:COUNT, COUNT values with both ends; NAME=FROM:TO:+STEP, steps from FROM
/// up to TO at most; or NAME=FROM:TO:/CELLS, the midpoints of CELLS equal cells.
///
/// With --from, the numbers are read from a result of `kahan sweep` or from a CSV file, and no
/// orbit is computed. --over NAME uses the values in the file; --over with a range shows the mean
/// of the rows in the cell around each value.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan chart lv --at 1,1 --over x=0:2:/9 --over eps=0:1:/9 --steps 99 --color fli --out lv.csv
  kahan chart --from lv.csv --over x --over eps --color fli --out lv.svg")]
// `--eps` is optional, because the rows of a file or --over may give ε.
#[command(mut_group("step", |step| step.required(false)))]
pub(crate) struct Chart {
    #[command(flatten)]
    start: Start,

    /// Draw rows of F.parquet, F.csv or a sweep's folder instead of orbits.
    #[arg(long, value_name = "F", conflicts_with_all = OF_ORBITS)]
    from: Option<PathBuf>,

    /// With --from: the column to show, if --color does not name it.
    #[arg(long, value_name = "NAME", requires = "from", conflicts_with = "color")]
    column: Option<String>,

    /// With --from: use only the rows in which column NAME has the value V.
    #[arg(long = "where", value_name = "NAME=V", requires = "from", allow_hyphen_values = true)]
    chosen: Vec<String>,

    /// The range to vary: NAME=FROM:TO:/CELLS or another form; once or twice.
    ///
    /// The first range is the horizontal axis.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, required = true)]
    over: Vec<String>,

    /// The number of steps of each orbit.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(1, MOST_STEPS), default_value = "1000")]
    steps: u64,

    #[command(flatten)]
    before: Transient,

    /// The observable, or a column such as rotation_x.
    #[arg(long, default_value = "sali", value_parser = Colours)]
    color: ColourColumn,

    /// End the orbit, as escaped, once a variable exceeds R in absolute value.
    #[arg(long, value_name = "R", allow_hyphen_values = true, value_parser = radius)]
    escape: Option<f64>,

    #[command(flatten)]
    stepping: Stepping,

    #[command(flatten)]
    rounding: Rounding,

    /// The output file: F.svg, F.png, F.pdf or F.csv.
    #[arg(long, value_name = "F")]
    out: PathBuf,

    #[command(flatten)]
    look: ImageOptions,

    /// Print one JSON object that describes the file.
    #[arg(long)]
    json: bool,
}

/// The options that describe orbits. None of them is allowed with --from.
const OF_ORBITS: [&str; 13] = [
    "system",
    "field",
    "file",
    "sites",
    "parameters",
    "eps",
    "dt",
    "at",
    "transient",
    "steps",
    "escape",
    "reembed",
    "fused",
];

/// Parses an observable with a single number, or a column such as `rotation_x`.
#[derive(Clone, Copy)]
struct Colours;

impl TypedValueParser for Colours {
    type Value = ColourColumn;

    fn parse_ref(
        &self,
        cmd: &Command,
        arg: Option<&Arg>,
        value: &OsStr,
    ) -> Result<ColourColumn, clap::Error> {
        let refused = |()| {
            observable_parser()
                .parse_ref(cmd, arg, value)
                .map(|of| ColourColumn::named(of.name()).expect("listed"))
        };
        value.to_str().and_then(ColourColumn::named).ok_or(()).or_else(refused)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        observable_parser()
            .possible_values()
            .map(|values| Box::new(values.collect::<Vec<_>>().into_iter()) as _)
    }
}

fn observable_parser() -> impl TypedValueParser<Value = Observable> {
    observable(Observable::ALL.iter().filter(|one| one.label().is_some()))
}

const MOST_STEPS: u64 = 1 << 40;

impl QuestionCommand for Chart {
    type Question = Over;

    fn read_question(&self) -> Result<(Study, Over), UsageError> {
        let axes = self.over.iter().map(|over| reading::over(over));
        let axes: Vec<Axis> = axes.collect::<Result<_, _>>()?;
        let (study, at, eps) = self.start.study_over(&axes)?;
        let study = study.fusing(self.rounding.fused)?;
        let gone_through = axes.iter().find(|axis| axis.name == "eps").map(|axis| axis.range.value(0));
        let eps = eps.or(gone_through).ok_or(StudyError::MissingStep)?;
        let observe = Observe {
            transient: self.before.transient,
            escape: self.escape,
            observe: vec![self.color.observable],
            reembed: self.stepping.reembed,
            ..Observe::new(eps, at, self.steps)
        };
        // The first range of a chart varies fastest, but in `Over` the last axis does.
        let axes = axes.into_iter().rev().map(Into::into).collect();
        Ok((study, Over::new(Question::Observe(observe), axes)))
    }

    fn options(asked: &Over, line: CommandLine) -> CommandLine {
        let Question::Observe(observe) = &*asked.question else { return line };
        let mut said = json!(observe);
        if asked.over.iter().any(|axis| axis.name == "eps") {
            said["eps"] = Value::Null;
        }
        let Value::Object(over) = json!(asked)["over"].take() else { return line };
        said["over"] = over.into_iter().rev().collect();
        said["color"] = json!(observe.observe[0].name());
        line.with_changed_options::<Self>(&said).with("--out", "chart.svg")
    }

    fn run(&self) -> Result<Answer, UsageError> {
        let out = OutFile::picture_or_table(&self.out)?;
        let shown = match &self.from {
            _ if self.over.len() > 2 => {
                return Err(UsageError::new(
                    "--over: a chart has one range or two, as in --over x=-1:1:/60 --over y=0:2:/60",
                ));
            }
            Some(from) => self.of_rows(from)?,
            None => self.of_orbits()?,
        };
        let picture = chart(&shown, &PictureOptions::on(self.look.sheet(usual())));
        out.put(&picture.drawing, || table(&shown))?;
        let values = shown.values.iter().filter(|value| !value.is_nan());
        let ends = [f64::min as fn(f64, f64) -> f64, f64::max];
        let [least, greatest] = ends.map(|end| values.clone().copied().reduce(end));
        let (out, cells) = (self.out.display().to_string(), shown.values.len());
        let empty = cells - values.count();
        if self.json {
            return Ok(Answer::json(&json!({
                "system": shown.name, "color": shown.column, "out": out, "shows": picture.drawing.description, "cells": cells,
                "empty": empty, "ended": shown.ends().into_iter().collect::<HashMap<_, _>>(), "least": least,
                "greatest": greatest,
            })));
        }
        let ends = least.zip(greatest);
        let ends =
            ends.map_or(String::new(), |(least, greatest)| format!(", from {least:.4} to {greatest:.4}"));
        let what = if self.from.is_some() { "cells" } else { "orbits" };
        Ok(Answer::text(format!("{out} written: {cells} {what}, {empty} empty; {}{ends}\n", shown.label())))
    }
}

impl Chart {
    fn of_orbits(&self) -> Result<PictureRequest, UsageError> {
        let (study, asked) = self.read_question()?;
        let shade = ColourColumn::read(&self.color.column, &study)?;
        let found = asked.ask(&study, &ProgressDisplay::new(asked.cells(&study)?, "orbits"))?;
        Ok(PictureRequest::of(&asked, &found, &shade))
    }

    fn of_rows(&self, from: &Path) -> Result<PictureRequest, UsageError> {
        let column = self.column.clone().unwrap_or_else(|| self.color.column.clone());
        let rows = Rows { from, over: &self.over, column: column.clone(), chosen: &self.chosen };
        let (axes, values) = rows.cells(PictureRequest::scale(&column))?;
        Ok(PictureRequest::of_column(from.display().to_string(), axes, column, values))
    }
}

/// Returns a CSV table with a row for each orbit; the first range varies fastest.
fn table(shown: &PictureRequest) -> String {
    let floats = |axis: &Axis| axis.range.values().map(|value| value.to_f64()).collect::<Vec<_>>();
    let along: Vec<Vec<f64>> = shown.axes.iter().map(floats).collect();
    let log = if shown.is_logarithm { "log_" } else { "" };
    let mut headings: Vec<String> = shown.axes.iter().map(|axis| axis.name.clone()).collect();
    headings.push(format!("{log}{}", shown.column));
    if !shown.ended.is_empty() {
        headings.extend(["ended", "ended_step"].map(str::to_owned));
    }
    let rows = shown.values.iter().enumerate().map(|(index, value)| {
        let places = [index % along[0].len(), index / along[0].len()];
        let mut row: Vec<String> =
            along.iter().zip(places).map(|(along, place)| format!("{:?}", along[place])).collect();
        row.push(if value.is_finite() { format!("{value:?}") } else { String::new() });
        row.extend(
            shown.ended.get(index).into_iter().flat_map(|(ended, step)| [ended.clone(), step.to_string()]),
        );
        row
    });
    csv(&[headings].into_iter().chain(rows).collect::<Vec<_>>())
}
