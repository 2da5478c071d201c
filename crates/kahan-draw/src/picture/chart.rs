//! What an observer says of orbits over one range, as a curve, or over two, in colours.

use kahan_study::{Axis, Kept, Observable, Observe, Over, OverFound, Question, Through, Varied};

use super::{Look, Picture};
use crate::plot::{Grid, Mark, NumberLine, Plot, Series};

/// Numbers over one range or two.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The ranges, the abscissa first.
    pub axes: Vec<Axis>,
    /// Row by row from below; not a number where a cell is empty.
    pub values: Vec<f64>,
    /// Of what the numbers are: a system, or the file that they come from.
    pub name: String,
    /// The name of what they are.
    pub column: String,
    /// Whether they are logarithms of it, to base 10.
    pub is_logarithm: bool,
    label: String,
    description: String,
}

/// To base 10; what is smaller than a rounding of 1 counts as that.
fn logarithm(value: f64) -> f64 {
    if value < f64::EPSILON { f64::EPSILON.log10() } else { value.log10() }
}

impl Chart {
    /// What the first observable of [`Observe`] says of orbits over one or two ranges, the last
    /// axis of the question to the right. A cell is empty where its orbit leaves the range of
    /// doubles, and under `escape` where it does not escape.
    ///
    /// # Panics
    /// If the question is another, or something goes through other values than a range's.
    #[must_use]
    pub fn of(asked: &Over, found: &OverFound) -> Self {
        let Question::Observe(observe) = &*asked.question else { panic!("a chart shows what is observed") };
        let axis = |axis: &Varied| match &axis.through {
            Through::Range(range) => Axis { name: axis.name.clone(), range: range.clone() },
            other => panic!("a chart goes through ranges, and not {other:?}"),
        };
        let axes: Vec<Axis> = asked.axes.iter().rev().map(axis).collect();
        let shown = observe.of[0];
        let is_logarithm = Self::is_logarithmic(shown.name());
        let (name, column) = (found.system.clone(), shown.name().to_owned());
        let values = values(observe, axes.len(), found);
        let chart = Chart::new(axes, values, name, column, is_logarithm);
        let label = label(shown).to_owned();
        let over = chart.over(&label);
        Chart { description: format!("{over}, {} steps each", observe.steps), label, ..chart }
    }

    /// Whether the numbers of a column have so many powers of ten that their logarithms are shown.
    #[must_use]
    pub fn is_logarithmic(column: &str) -> bool {
        column == "sali" || column.starts_with("drift")
    }

    /// How the numbers of a column are shown: as logarithms to base 10, or as they are.
    #[must_use]
    pub fn scale(column: &str) -> fn(f64) -> f64 {
        if Self::is_logarithmic(column) { logarithm } else { |value| value }
    }

    /// Numbers of a column of a file, on their [scale](Chart::scale).
    #[must_use]
    pub fn of_column(name: String, axes: Vec<Axis>, column: String, values: Vec<f64>) -> Self {
        let is_logarithm = Self::is_logarithmic(&column);
        Chart::new(axes, values, name, column, is_logarithm)
    }

    fn new(axes: Vec<Axis>, values: Vec<f64>, name: String, column: String, is_logarithm: bool) -> Self {
        let label = if is_logarithm { format!("log {column}, to base 10") } else { column.clone() };
        let chart = Chart {
            axes,
            values,
            name,
            column,
            is_logarithm,
            label: String::new(),
            description: String::new(),
        };
        Chart { description: chart.over(&label), label, ..chart }
    }

    /// What the numbers are, in words.
    #[must_use]
    pub fn label(&self) -> &str {
        &self.label
    }

    /// What is shown, in words: the values of a curve, the cells of a grid.
    fn over(&self, label: &str) -> String {
        let through = |axis: &Axis| {
            let [from, to] = if self.axes.len() == 1 { axis.range.ends() } else { axis.range.edges() };
            format!("{} from {from} to {to}", axis.name)
        };
        let axes: Vec<String> = self.axes.iter().map(through).collect();
        format!("{label} of {} over {}", self.name, axes.join(" and "))
    }
}

/// What is shown, in words.
fn label(shown: Observable) -> &'static str {
    match shown {
        Observable::Sali => "log SALI, to base 10",
        Observable::Fli => "FLI",
        Observable::Megno => "mean MEGNO",
        Observable::Lyapunov => "largest exponent, per unit of time",
        Observable::Drift => "log of the greatest drift, to base 10",
        Observable::Escape => "step of the escape",
        other => other.name(),
    }
}

/// What each cell shows, row by row from below; not a number where it is empty.
fn values(asked: &Observe, axes: usize, found: &OverFound) -> Vec<f64> {
    let first = 1 + axes;
    let Kept::Integer(steps) = &found.rows.values[first] else { unreachable!("steps are counted") };
    let numbers = |column: usize| match &found.rows.values[first + column] {
        Kept::F64(numbers) => numbers,
        other => unreachable!("what is observed is a number, and not {other:?}"),
    };
    let value = |(cell, steps): (usize, &i64)| {
        let (own, leaves) = (numbers(1)[cell], *steps < asked.steps as i64);
        match asked.of[0] {
            // What is beyond all numbers is beyond a size.
            Observable::Escape if own.is_nan() && leaves && !numbers(2)[cell].is_nan() => (steps + 1) as f64,
            Observable::Escape => own,
            _ if leaves => f64::NAN,
            Observable::Drift => {
                // Of each integral the greatest, and behind it the last.
                let count = found.rows.values.len() - first - 1;
                logarithm((1..=count).step_by(2).map(|k| numbers(k)[cell]).fold(0.0, f64::max))
            }
            Observable::Sali => logarithm(own),
            _ => own,
        }
    };
    steps.iter().enumerate().map(value).collect()
}

/// A chart over one range or two.
#[must_use]
pub fn chart(shown: &Chart, look: &Look) -> Picture {
    let (description, sheet) = (shown.description.clone(), look.sheet);
    let picture = if let [axis] = &shown.axes[..] {
        let places = axis.range.values().map(|value| value.to_f64());
        let points: Vec<(f64, f64)> = places.zip(shown.values.iter().copied()).collect();
        // The dots show the values that no line leads to.
        let marked = [Mark::Line, Mark::Points].map(|mark| Series::new("", 1, mark, points.clone()));
        let plot = Plot::around(&description, [&axis.name, &shown.label], marked.into());
        Plot { sheet, ..plot }.drawing()
    } else {
        let line = |axis: &Axis| {
            let [low, high] = axis.range.edges().map(|edge| edge.to_f64());
            NumberLine { label: axis.name.clone(), low, high }
        };
        let [x, y] = [0, 1].map(|axis| line(&shown.axes[axis]));
        let scale = NumberLine::around_most(&shown.label, shown.values.iter().copied());
        let (columns, values) = (shown.axes[0].range.count(), shown.values.clone());
        Grid { description, sheet, x, y, scale, columns, values }.drawing()
    };
    let points = shown.values.iter().filter(|value| !value.is_nan()).count();
    Picture { drawing: picture, points, outside: 0, visits: Vec::new() }
}
