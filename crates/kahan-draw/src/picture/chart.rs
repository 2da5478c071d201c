//! Charts of an observable over one or two axes of equally spaced values.

use kahan_latex::symbol;
use kahan_study::{
    Axis, AxisOver, AxisValues, ColourColumn, Observable, Over, OverFound, Question, StoredColumn,
};

use super::{Picture, PictureOptions};
use crate::plot::{Grid, Mark, NumberLine, Plot, Series, TickKind};

/// The values of an observable over one or two axes of equally spaced values.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The axes. The first axis is the abscissa.
    pub axes: Vec<Axis>,
    /// The values, row by row from below. Empty cells are NaN.
    pub values: Vec<f64>,
    /// The name of the system, or of the file that holds the values.
    pub name: String,
    /// The name of the shown column.
    pub column: String,
    /// Whether the values are logarithms to base 10.
    pub is_logarithm: bool,
    /// Whether some values are only lower bounds of the number of passed poles.
    pub is_lower_bound: bool,
    /// For each cell, how its orbit ended and after how many steps. Empty if the values are from a
    /// file.
    pub ended: Vec<(String, i64)>,
    steps: Option<u64>,
}

/// Returns the logarithm to base 10 of the larger of `value` and `f64::EPSILON`.
fn logarithm(value: f64) -> f64 {
    if value < f64::EPSILON { libm::log10(f64::EPSILON) } else { libm::log10(value) }
}

impl Chart {
    /// Charts one column of an [`Observe`](kahan_study::Observe) over one or two ranges. The last
    /// range becomes the horizontal axis. The cell of an orbit that ends early is empty. In the
    /// column `escape`, the cell of an orbit that does not escape is empty. Panics without an
    /// `Observe` or ranges.
    #[must_use]
    pub fn of(asked: &Over, found: &OverFound, shade: &ColourColumn) -> Self {
        let Question::Observe(observe) = &*asked.question else { panic!("a chart shows what is observed") };
        let axis = |axis: &AxisOver| match &axis.through {
            AxisValues::Range(range) => Axis { name: axis.name.clone(), range: range.clone() },
            other => panic!("a chart goes through ranges, and not {other:?}"),
        };
        let axes: Vec<Axis> = asked.over.iter().rev().map(axis).collect();
        let is_key = shade.column == shade.observable.key();
        let column = if is_key { shade.observable.name() } else { &shade.column };
        let values = shade.values(&found.rows).into_iter().map(Self::scale(column)).collect();
        let ends = &found.rows.values[1 + axes.len()..];
        let [StoredColumn::Text(ended), StoredColumn::Integer(steps), ..] = ends else {
            unreachable!("how an orbit ended is a word and a count")
        };
        let ended = ended.iter().cloned().zip(steps.iter().copied()).collect();
        let bounds = found.columns.iter().position(|name| name == "passed_poles_lower_bound");
        let is_lower_bound = match bounds.map(|place| &found.rows.values[place]) {
            Some(StoredColumn::F64(bounds)) => bounds.contains(&1.0),
            _ => false,
        };
        let chart = Chart::of_column(found.system.clone(), axes, column.to_owned(), values);
        Chart { is_lower_bound, ended, steps: Some(observe.steps), ..chart }
    }

    /// Returns whether charts show the logarithm of a column.
    #[must_use]
    pub fn is_logarithmic(column: &str) -> bool {
        Observable::of_column(column).is_some_and(Observable::is_logarithmic)
    }

    /// Returns the function that charts apply to a column, the logarithm or the identity.
    #[must_use]
    pub fn scale(column: &str) -> fn(f64) -> f64 {
        if Self::is_logarithmic(column) { logarithm } else { |value| value }
    }

    /// Charts a column of a file. Its `values` are already transformed by [`scale`](Chart::scale).
    #[must_use]
    pub fn of_column(name: String, axes: Vec<Axis>, column: String, values: Vec<f64>) -> Self {
        let is_logarithm = Self::is_logarithmic(&column);
        let (is_lower_bound, ended) = (false, Vec::new());
        Chart { axes, values, name, column, is_logarithm, is_lower_bound, ended, steps: None }
    }

    /// Returns the name of the shown values.
    #[must_use]
    pub fn label(&self) -> String {
        let quantity = self.quantity();
        if self.is_logarithm { format!("log₁₀ of {quantity}") } else { quantity }
    }

    fn quantity(&self) -> String {
        let quantity = quantity(&self.column);
        if self.is_lower_bound { format!("{quantity}, at least") } else { quantity }
    }

    /// Describes the axes. With two axes, each range includes the outer halves of the end cells.
    fn description(&self) -> String {
        let through = |axis: &Axis| {
            let ends = if self.axes.len() == 1 { axis.range.ends() } else { axis.range.edges() };
            let [from, to] = ends.map(|end| end.to_f64());
            format!("{} from {from} to {to}", axis.name)
        };
        let axes: Vec<String> = self.axes.iter().map(through).collect();
        let steps = self.steps.map_or(String::new(), |steps| format!(", {steps} steps each"));
        format!("{} of {} over {}{steps}", self.label(), self.name, axes.join(" and "))
    }

    /// Counts the orbits that ended early, for each kind of end.
    #[must_use]
    pub fn ends(&self) -> Vec<(&str, usize)> {
        let count = |name| self.ended.iter().filter(|(ended, _)| ended == name).count();
        let counts = ["range", "escaped"].map(|name| (name, count(name)));
        counts.into_iter().filter(|(_, count)| *count > 0).collect()
    }

    fn early_ends(&self) -> String {
        let words = |(name, count): &(&str, usize)| match *name {
            "escaped" => format!("{count} escaped"),
            _ => format!("{count} left the range of doubles"),
        };
        let ends: Vec<String> = self.ends().iter().map(words).collect();
        if ends.is_empty() { String::new() } else { format!(": {}", ends.join(", ")) }
    }

    /// Returns a note if cells are empty, if all values are equal, or if some lie outside of
    /// `scale`.
    fn note(&self, scale: Option<&NumberLine>) -> String {
        const ROUNDING: f64 = 1e-13;

        let numbers = || self.values.iter().copied().filter(|value| value.is_finite());
        let (low, high) = (numbers().fold(f64::MAX, f64::min), numbers().fold(f64::MIN, f64::max));
        let value = if self.is_logarithm { libm::exp10(low) } else { low };
        match high - low {
            length if length < 0.0 => format!("every cell is empty{}", self.early_ends()),
            _ if self.is_logarithm && high <= libm::log10(ROUNDING) => {
                "no more than rounding in all cells".to_owned()
            }
            length if length <= 1e-9 * high.abs() => format!("the same in all cells: {value:.6}"),
            _ => {
                let beyond =
                    numbers().filter(|value| scale.is_some_and(|scale| !scale.shows(*value))).count();
                let empty = self.values.len() - numbers().count();
                let beyond = (beyond > 0).then(|| {
                    format!("values from {low:.3} to {high:.3}, {beyond} of them beyond the colours")
                });
                let empty = (empty > 0 && scale.is_some())
                    .then(|| format!("{empty} cells empty{}", self.early_ends()));
                beyond.into_iter().chain(empty).collect::<Vec<_>>().join("; ")
            }
        }
    }
}

fn quantity(column: &str) -> String {
    let observable = Observable::of_column(column).filter(|one| [one.name(), one.key()].contains(&column));
    observable.and_then(Observable::label).map_or_else(|| symbol(column), str::to_owned)
}

/// Draws a chart.
#[must_use]
pub fn chart(shown: &Chart, look: &PictureOptions) -> Picture {
    let (description, sheet) = (shown.description(), look.sheet);
    let marks = if shown.is_logarithm { TickKind::Powers } else { TickKind::Round };
    let quantity = shown.quantity();
    let picture = if let [axis] = &shown.axes[..] {
        let places = axis.range.values().map(|value| value.to_f64());
        let points: Vec<(f64, f64)> = places.zip(shown.values.iter().copied()).collect();
        // A line cannot show a value between two empty cells, so dots are drawn too.
        let marked = [Mark::Line, Mark::Points].map(|mark| Series::new("", 1, mark, points.clone()));
        let plot = Plot::around(&description, [&*symbol(&axis.name), &*quantity], marked.into());
        let y = NumberLine { marks, ..plot.y };
        Plot { sheet, y, note: shown.note(None), ..plot }.drawing()
    } else {
        let line = |axis: &Axis| {
            let [low, high] = axis.range.edges().map(|edge| edge.to_f64());
            NumberLine::new(&symbol(&axis.name), low, high)
        };
        let [x, y] = [0, 1].map(|axis| line(&shown.axes[axis]));
        let scale = NumberLine { marks, ..NumberLine::around_most(&quantity, shown.values.iter().copied()) };
        let (columns, values, note) =
            (shown.axes[0].range.count(), shown.values.clone(), shown.note(Some(&scale)));
        Grid { description, sheet, x, y, scale, columns, values, note }.drawing()
    };
    let points = shown.values.iter().filter(|value| !value.is_nan()).count();
    Picture { drawing: picture, points, outside: 0, visits: Vec::new() }
}
