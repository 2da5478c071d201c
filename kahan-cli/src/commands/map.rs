//! `kahan map`: stability maps, an ensemble over two coordinates or parameters in colours.

mod cells;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use serde_json::json;

use crate::plot::{Drawing, Format, Grid, NumberLine, Sheet, Theme};
use crate::printing::{Answer, Refusal, Sink};
use crate::reading::{Range, Request, Start, whole};

use cells::Cells;

/// Draws a stability map: what orbits do over two coordinates or parameters.
///
/// Each cell of the grid is an orbit that begins at the middle of the cell, in doubles, for the same
/// number of steps; its colour is what an observer says of it. Two of the variables' first values,
/// the parameters and eps are gone through; the others are those of --at, --param and --eps. SALI and
/// drift are shown as logarithms to base 10. A cell stays empty where its orbit leaves the range of
/// doubles, and under `escape` where it does not escape. The numbers do not depend on the number of
/// threads. The file is a picture, or a table of the numbers with a row a cell.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct StabilityMap {
    #[command(flatten)]
    start: Start,

    /// What is gone through, NAME=FROM:TO:CELLS: twice, the abscissa first.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, required = true)]
    over: Vec<String>,

    /// The number of steps of each orbit.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = steps)]
    steps: u64,

    /// What is shown.
    #[arg(long, value_enum, default_value = "sali")]
    color: Colour,

    /// The orbit has escaped where a variable is larger than R in size.
    #[arg(long, value_name = "R", default_value = "1e6", allow_hyphen_values = true, hide_short_help = true)]
    escape: String,

    /// The file, F.svg, F.png or F.csv, which appears when it is complete.
    #[arg(long, value_name = "F")]
    out: PathBuf,

    /// Width and height in pixels.
    #[arg(long, value_name = "WxH", default_value = "960x720", value_parser = super::picture::pixels)]
    size: (u32, u32),

    /// Which colours a picture has around the map.
    #[arg(long, value_enum, default_value = "viewer", hide_short_help = true)]
    theme: Theme,

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
  kahan map e3 --eps 0.1 --at 1,2,3 --over x=-2:2:40 --over y=-2:2:40 --steps 200 --out e3.svg
  kahan map lv --eps 1 --at 1,1 --over x=0:2:9 --over eps=0:1:9 --steps 99 --color fli --out lv.csv
  kahan map volterra --eps 0.1 --at 1,1,1 --over x=0:3:9 --over y=0:3:9 --steps 9 --out w.svg";

fn steps(text: &str) -> Result<u64, String> {
    whole(text, 1, 1 << 40)
}

impl Colour {
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

impl StabilityMap {
    /// Writes the file; the answer says what is in it.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let ranges = self.ranges()?;
        let is_table = self.out.extension().is_some_and(|ending| ending == "csv");
        let format = if is_table { None } else { Some(Format::of(&self.out)?) };
        let sink = Sink::file(&self.out, "--out")?;
        let request = self.start.request()?;
        let values = Cells::new(&request, &ranges, self.color, self.steps, &self.escape)?.values()?;
        let file = match format {
            Some(format) => self.grid(&request, &ranges, &values).drawing()?.file(format, &self.sheet())?,
            None => table(&ranges, self.color, &values).into_bytes(),
        };
        sink.put(file)?;
        let shown = values.iter().filter(|value| !value.is_nan());
        let extremes = shown.clone().fold(None, |ends: Option<(f64, f64)>, value| {
            let (least, greatest) = ends.unwrap_or((*value, *value));
            Some((least.min(*value), greatest.max(*value)))
        });
        let (out, empty) = (self.out.display().to_string(), values.len() - shown.count());
        if self.json {
            let color = self.color.to_possible_value().map(|value| value.get_name().to_owned());
            return Ok(Answer::json(&json!({
                "system": request.name, "color": color, "out": out, "shows": self.description(&request, &ranges),
                "cells": values.len(), "empty": empty, "least": extremes.map(|ends| ends.0), "greatest": extremes.map(|ends| ends.1),
            })));
        }
        let ends =
            extremes.map_or(String::new(), |(least, greatest)| format!(", from {least:.4} to {greatest:.4}"));
        Ok(Answer::text(format!(
            "{out} written: {} of {} orbits{ends}, {empty} empty\n",
            self.color.label(),
            values.len()
        )))
    }

    /// The picture.
    pub(super) fn drawn(&self) -> Result<Drawing, Refusal> {
        let (ranges, request) = (self.ranges()?, self.start.request()?);
        let values = Cells::new(&request, &ranges, self.color, self.steps, &self.escape)?.values()?;
        self.grid(&request, &ranges, &values).drawing()
    }

    fn ranges(&self) -> Result<[Range<'_>; 2], Refusal> {
        let [x, y] = &self.over[..] else {
            return Err(Refusal::new(
                "--over: a map goes through two ranges, as in --over x=-1:1:60 --over y=0:2:60",
            ));
        };
        Ok([Range::read(x)?, Range::read(y)?])
    }

    fn sheet(&self) -> Sheet {
        Sheet { pixels: self.size, theme: self.theme }
    }

    /// What is shown, in words.
    fn description(&self, request: &Request, [across, upwards]: &[Range<'_>; 2]) -> String {
        format!(
            "{} of {} over {} from {} to {} and {} from {} to {}, {} steps each",
            self.color.label(),
            request.name,
            across.name,
            across.from,
            across.to,
            upwards.name,
            upwards.from,
            upwards.to,
            self.steps
        )
    }

    fn grid(&self, request: &Request, ranges: &[Range<'_>; 2], values: &[f64]) -> Grid {
        let line = |range: &Range<'_>| NumberLine {
            label: range.name.to_owned(),
            low: range.from.to_f64(),
            high: range.to.to_f64(),
        };
        Grid {
            description: self.description(request, ranges),
            size: self.sheet().view_box(),
            x: line(&ranges[0]),
            y: line(&ranges[1]),
            scale: NumberLine::around_most(self.color.label(), values.iter().copied()),
            columns: ranges[0].steps,
            values: values.to_vec(),
        }
    }
}

/// A row a cell, and the names of what is in it.
fn table(ranges: &[Range<'_>; 2], colour: Colour, values: &[f64]) -> String {
    let [across, upwards] = ranges;
    let name = colour.to_possible_value().map_or(String::new(), |value| value.get_name().to_owned());
    let columns: Vec<f64> = across.middles().map(|value| value.to_f64()).collect();
    let rows = upwards.middles().map(|value| value.to_f64()).zip(values.chunks_exact(across.steps));
    let mut text = format!("{},{},{name}\n", across.name, upwards.name);
    for (row, values) in rows {
        for (column, value) in columns.iter().zip(values) {
            let cell = if value.is_finite() { format!("{value:?}") } else { String::new() };
            text += &format!("{column:?},{row:?},{cell}\n");
        }
    }
    text
}
