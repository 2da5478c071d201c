//! `kahan chart`: what an observer says of orbits over one coordinate or parameter, as a curve, or
//! over two, in colours.

mod cells;
mod rows;

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use kahan_draw::{Drawing, Grid, Mark, NumberLine, Plot, Series};
use kahan_study::{Axis, Spacing};
use serde_json::json;

use super::look::{Look, file, format};
use crate::printing::{Answer, Refusal, Sink};
use crate::reading::{self, Start, whole};

use cells::Cells;
use rows::Rows;

/// Charts what orbits do over one or two coordinates or parameters.
///
/// One or two of the variables' first values, the parameters and eps are gone through; the others
/// are those of --at, --param and --eps. At each value, or pair of values, an orbit begins, in
/// doubles, for the same number of steps, and an observer says what it does: over one range a curve
/// shows it, over two the colour of a cell around the values. SALI and drift are shown as
/// logarithms to base 10. The curve has a gap, and the cell stays empty, where the orbit leaves the
/// range of doubles, and under `escape` where it does not escape. The numbers do not depend on the
/// number of threads. The file is a picture, or a table of the numbers with a row an orbit.
///
/// A range is NAME=FROM:TO:COUNT, so many values with both ends; NAME=FROM:TO:+STEP, steps from
/// FROM as long as TO is not passed; or NAME=FROM:TO:/CELLS, the middles of so many cells.
///
/// With --from the numbers are those of a result of `kahan sweep`, or of a CSV file, and no orbit
/// is followed. --over NAME goes through the values that are there, and --over with a range shows
/// the mean of the rows in the cell around each value.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
// Rows have ε and their places in themselves, and ε may be gone through.
#[command(mut_arg("eps", |eps| eps.required(false)))]
#[command(mut_arg("at", |at| at.required(false).required_unless_present("from")))]
pub(crate) struct Chart {
    #[command(flatten)]
    start: Start,

    /// Draw the rows of F.parquet, F.csv or the folder of a sweep in the place of orbits.
    #[arg(long, value_name = "F", conflicts_with_all = OF_ORBITS)]
    from: Option<PathBuf>,

    /// The column of F that is shown, where it is not named as --color.
    #[arg(long, value_name = "NAME", requires = "from", conflicts_with = "color")]
    column: Option<String>,

    /// Only the rows of F in which a column has this value.
    #[arg(long = "where", value_name = "NAME=V", requires = "from", allow_hyphen_values = true)]
    chosen: Vec<String>,

    /// What is gone through, NAME=FROM:TO:/CELLS or the like: once, or twice, the abscissa first.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, required = true)]
    over: Vec<String>,

    /// The number of steps of each orbit.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = steps, default_value = "1000")]
    steps: u64,

    /// What is shown.
    #[arg(long, value_enum, default_value = "sali")]
    color: Colour,

    /// The orbit has escaped where a variable is larger than R in size.
    #[arg(long, value_name = "R", default_value = "1e6", allow_hyphen_values = true)]
    escape: String,

    /// The file, F.svg, F.png or F.csv, which appears when it is complete.
    #[arg(long, value_name = "F")]
    out: PathBuf,

    #[command(flatten)]
    look: Look,

    /// Print one JSON object that says what the file shows.
    #[arg(long)]
    json: bool,
}

/// What a cell shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Colour {
    /// The smaller alignment index, as a logarithm.
    Sali,
    /// The fast Lyapunov indicator.
    Fli,
    /// The mean of MEGNO.
    Megno,
    /// The largest Lyapunov exponent.
    Lyapunov,
    /// The greatest drift of the claimed integrals, as a logarithm.
    Drift,
    /// The step of the escape.
    Escape,
}

const EXAMPLES: &str = "\
Examples:
  kahan chart e3 --eps 0.1 --at 1,2,3 --over x=-2:2:/40 --over y=-2:2:/40 --steps 200 --out e3.svg
  kahan chart lv --eps 1/7 --at 1,1 --over x=1/10:1:+1/50 --color fli --out fli.svg
  kahan chart lv --at 1,1 --over x=0:2:/9 --over eps=0:1:/9 --steps 99 --color fli --out lv.csv
  kahan chart --from lv.csv --over x --over eps --color fli --out lv.svg";

/// What orbits need, and rows have in themselves.
const OF_ORBITS: [&str; 9] =
    ["system", "field", "file", "sites", "parameters", "eps", "at", "steps", "escape"];

fn steps(text: &str) -> Result<u64, String> {
    whole(text, 1, 1 << 40)
}

impl Colour {
    /// Its word on the command line.
    fn name(self) -> String {
        self.to_possible_value().map_or(String::new(), |value| value.get_name().to_owned())
    }

    /// The column of a sweep that holds it.
    fn column(self) -> String {
        if self == Colour::Escape { "escaped".to_owned() } else { self.name() }
    }

    fn label(self) -> &'static str {
        match self {
            Colour::Sali => "log SALI, to base 10",
            Colour::Fli => "FLI",
            Colour::Megno => "mean MEGNO",
            Colour::Lyapunov => "largest exponent, per unit of time",
            Colour::Drift => "log of the greatest drift, to base 10",
            Colour::Escape => "step of the escape",
        }
    }
}

/// What a chart shows.
struct Shown {
    /// One or two.
    axes: Vec<Axis>,
    /// Row by row from below.
    values: Vec<f64>,
    /// Of what.
    name: String,
    /// What of it.
    column: String,
    /// Whether of that the logarithm to base 10.
    is_logarithm: bool,
    label: String,
    description: String,
}

impl Chart {
    /// Writes the file; the answer says what is in it.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let is_table = self.out.extension().is_some_and(|ending| ending == "csv");
        let format = if is_table { None } else { Some(format(&self.out)?) };
        let sink = Sink::file(&self.out, "--out")?;
        let shown = self.shown()?;
        let file = match format {
            Some(format) => file(&self.drawing(&shown), format, &self.look.sheet())?,
            None => table(&shown).into_bytes(),
        };
        sink.put(file)?;
        let values = shown.values.iter().filter(|value| !value.is_nan());
        let extremes = values.clone().fold(None, |ends: Option<(f64, f64)>, value| {
            let (least, greatest) = ends.unwrap_or((*value, *value));
            Some((least.min(*value), greatest.max(*value)))
        });
        let (out, cells, empty) =
            (self.out.display().to_string(), shown.values.len(), shown.values.len() - values.count());
        if self.json {
            return Ok(Answer::json(&json!({
                "system": shown.name, "color": shown.column, "out": out, "shows": shown.description, "cells": cells,
                "empty": empty, "least": extremes.map(|ends| ends.0), "greatest": extremes.map(|ends| ends.1),
            })));
        }
        let ends =
            extremes.map_or(String::new(), |(least, greatest)| format!(", from {least:.4} to {greatest:.4}"));
        let what = if self.from.is_some() { "cells" } else { "orbits" };
        Ok(Answer::text(format!("{out} written: {} of {cells} {what}{ends}, {empty} empty\n", shown.label)))
    }

    /// The picture.
    pub(super) fn drawn(&self) -> Result<Drawing, Refusal> {
        Ok(self.drawing(&self.shown()?))
    }

    fn shown(&self) -> Result<Shown, Refusal> {
        if self.over.len() > 2 {
            return Err(Refusal::new(
                "--over: a chart goes through one range or two, as in --over x=-1:1:/60 --over y=0:2:/60",
            ));
        }
        match &self.from {
            Some(from) => self.of_rows(from),
            None => self.of_orbits(),
        }
    }

    fn of_orbits(&self) -> Result<Shown, Refusal> {
        let axes = self.over.iter().map(|over| reading::over(over, Spacing::Cells));
        let axes: Vec<Axis> = axes.collect::<Result<_, _>>()?;
        let request = self.start.request_over(&axes)?;
        let values = Cells::new(&request, &axes, self.color, self.steps, &self.escape)?.values()?;
        let label = self.color.label().to_owned();
        let is_logarithm = matches!(self.color, Colour::Sali | Colour::Drift);
        let description = format!("{}, {} steps each", over(&label, &request.name, &axes), self.steps);
        Ok(Shown {
            axes,
            values,
            name: request.name,
            column: self.color.name(),
            is_logarithm,
            label,
            description,
        })
    }

    fn of_rows(&self, from: &Path) -> Result<Shown, Refusal> {
        let column = self.column.clone().unwrap_or_else(|| self.color.column());
        let rows = Rows { from, over: &self.over, column, chosen: &self.chosen };
        let is_logarithm = rows.column == "sali" || rows.column.starts_with("drift");
        let (axes, values) =
            rows.cells(|value| if is_logarithm { cells::logarithm(value) } else { value })?;
        let column = rows.column;
        let label = if is_logarithm { format!("log {column}, to base 10") } else { column.clone() };
        let name = from.display().to_string();
        let description = over(&label, &name, &axes);
        Ok(Shown { axes, values, name, column, is_logarithm, label, description })
    }

    fn drawing(&self, shown: &Shown) -> Drawing {
        match &shown.axes[..] {
            [axis] => self.curve(shown, axis).drawing(),
            axes => self.grid(shown, axes).drawing(),
        }
    }

    /// The values over one range.
    fn curve(&self, shown: &Shown, axis: &Axis) -> Plot {
        let places = axis.range.values().map(|value| value.to_f64());
        let points: Vec<(f64, f64)> = places.zip(shown.values.iter().copied()).collect();
        // The dots show the values that no line leads to.
        let marked = [Mark::Line, Mark::Points].map(|mark| Series::new("", 1, mark, points.clone()));
        let plot = Plot::around(&shown.description, [&axis.name, &shown.label], marked.into());
        Plot { size: self.look.sheet().view_box(), ..plot }
    }

    fn grid(&self, shown: &Shown, axes: &[Axis]) -> Grid {
        let line = |axis: &Axis| {
            let [low, high] = axis.range.edges().map(|edge| edge.to_f64());
            NumberLine { label: axis.name.to_owned(), low, high }
        };
        Grid {
            description: shown.description.clone(),
            size: self.look.sheet().view_box(),
            x: line(&axes[0]),
            y: line(&axes[1]),
            scale: NumberLine::around_most(&shown.label, shown.values.iter().copied()),
            columns: axes[0].range.count(),
            values: shown.values.clone(),
        }
    }
}

/// What is shown, in words: the values of a curve, the cells of a grid.
fn over(label: &str, name: &str, axes: &[Axis]) -> String {
    let through = |axis: &Axis| {
        let [from, to] = if axes.len() == 1 { axis.range.ends() } else { axis.range.edges() };
        format!("{} from {from} to {to}", axis.name)
    };
    let axes: Vec<String> = axes.iter().map(through).collect();
    format!("{label} of {name} over {}", axes.join(" and "))
}

/// A row an orbit, and the names of what is in it; the first range runs fastest.
fn table(shown: &Shown) -> String {
    let floats = |axis: &Axis| axis.range.values().map(|value| value.to_f64()).collect::<Vec<_>>();
    let names: Vec<&str> = shown.axes.iter().map(|axis| axis.name.as_str()).collect();
    let along: Vec<Vec<f64>> = shown.axes.iter().map(floats).collect();
    let log = if shown.is_logarithm { "log_" } else { "" };
    let mut text = format!("{},{log}{}\n", names.join(","), shown.column);
    for (index, value) in shown.values.iter().enumerate() {
        let places = [index % along[0].len(), index / along[0].len()];
        along.iter().zip(places).for_each(|(along, place)| text += &format!("{:?},", along[place]));
        if value.is_finite() {
            text += &format!("{value:?}");
        }
        text.push('\n');
    }
    text
}
