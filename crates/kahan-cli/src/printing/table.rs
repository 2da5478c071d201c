//! A table of numbers while it grows: CSV, or the rows of a JSON object.
//!
//! Names are identifiers and numbers have no commas, so that no cell needs quotes. The crate `csv`,
//! which looks at each byte of a cell for what would, has nothing to do here but to put commas.

use serde_json::{Map, Value};

use super::layout::{after_commas, terminal_width};
use super::sink::{Broken, Sink};
use crate::numbers::Printable;

/// How a table is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// A line of column names, then a line a row; what is undefined is empty. A terminal breaks a
    /// long line after commas.
    Csv,
    /// One object: what is known beforehand, `rows`, and `stopped`; what is undefined is null.
    Json,
}

/// A cell of a row that may be at infinity.
pub(crate) enum Cell<V> {
    /// A number.
    Value(V),
    /// Infinite without a sign: `inf`, or null.
    Infinite,
    /// Nothing, or null.
    Undefined,
}

/// A table on its way into a sink.
pub(crate) struct Table {
    sink: Sink,
    format: Format,
    /// Which of several orbits the rows are of: their first cell.
    orbit: Option<usize>,
    /// The row being written, kept so that its memory is.
    line: String,
    has_rows: bool,
    /// The columns of the terminal that shows the rows.
    width: Option<usize>,
}

impl Table {
    /// A table without anything in it.
    pub(crate) fn new(sink: Sink, format: Format) -> Self {
        let width = terminal_width().filter(|_| sink.is_standard() && format == Format::Csv);
        Table { sink, format, orbit: None, line: String::new(), has_rows: false, width }
    }

    /// Writes what stands before the rows; `head` has the names of the columns under `columns`.
    pub(crate) fn begin(&mut self, head: &Map<String, Value>) -> Result<(), Broken> {
        let text = match self.format {
            Format::Csv => {
                let columns = head.get("columns").and_then(Value::as_array).into_iter().flatten();
                let line = columns.filter_map(Value::as_str).collect::<Vec<_>>().join(",") + "\n";
                self.width.map_or_else(|| line.clone(), |width| after_commas(&line, width))
            }
            Format::Json => {
                let entries =
                    head.iter().map(|(key, value)| format!("  {}: {value},\n", Value::from(key.as_str())));
                format!("{{\n{}  \"rows\": [", entries.collect::<String>())
            }
        };
        self.sink.write(&text)
    }

    /// Of several orbits, numbered from 0, the one that the next rows are of.
    pub(crate) fn begin_orbit(&mut self, orbit: usize) {
        self.orbit = Some(orbit);
    }

    /// Writes a row: an index, and the values behind it, `None` for what is undefined.
    pub(crate) fn row<'a, A: Printable>(
        &mut self,
        index: i64,
        values: impl Iterator<Item = Option<&'a A::Value>>,
    ) -> Result<(), Broken>
    where
        A::Value: 'a,
    {
        self.cells(index, values, append::<A>, |value| value.map_or(Value::Null, A::json))
    }

    /// Writes a row of a point that may be at infinity.
    pub(crate) fn projective<A: Printable>(
        &mut self,
        index: i64,
        cells: impl Iterator<Item = Cell<A::Value>>,
    ) -> Result<(), Broken> {
        let append = |cell: Cell<A::Value>, line: &mut String| match cell {
            Cell::Value(value) => append::<A>(Some(&value), line),
            Cell::Infinite => line.push_str("inf"),
            Cell::Undefined => {}
        };
        let json = |cell: Cell<A::Value>| match cell {
            Cell::Value(value) => A::json(&value),
            Cell::Infinite | Cell::Undefined => Value::Null,
        };
        self.cells(index, cells, append, json)
    }

    /// Writes a row of exact numbers that are text already.
    pub(crate) fn texts(&mut self, index: i64, values: &[Option<String>]) -> Result<(), Broken> {
        let values = values.iter().map(Option::as_deref);
        let append = |value: Option<&str>, line: &mut String| line.push_str(value.unwrap_or_default());
        self.cells(index, values, append, Value::from)
    }

    /// Writes a row, each cell by the function for the format.
    fn cells<C>(
        &mut self,
        index: i64,
        cells: impl Iterator<Item = C>,
        append: impl Fn(C, &mut String),
        json: impl Fn(C) -> Value,
    ) -> Result<(), Broken> {
        self.line.clear();
        match self.format {
            Format::Csv => {
                if let Some(orbit) = self.orbit {
                    self.line.push_str(&orbit.to_string());
                    self.line.push(',');
                }
                self.line.push_str(&index.to_string());
                for cell in cells {
                    self.line.push(',');
                    append(cell, &mut self.line);
                }
                self.line.push('\n');
            }
            Format::Json => {
                self.line.push_str(if self.has_rows { ",\n    " } else { "\n    " });
                let orbit = self.orbit.map(Value::from);
                let row: Value =
                    orbit.into_iter().chain([Value::from(index)]).chain(cells.map(json)).collect();
                self.line.push_str(&row.to_string());
            }
        }
        self.has_rows = true;
        match self.width {
            Some(width) if self.line.len() > width => self.sink.write(after_commas(&self.line, width)),
            _ => self.sink.write(&self.line),
        }
    }

    /// Writes what stands behind the rows, and closes the sink; `stopped` says why the rows ended
    /// early, or is null.
    pub(crate) fn end(mut self, stopped: &Value) -> Result<(), Broken> {
        if self.format == Format::Json {
            self.sink.write(format!("\n  ],\n  \"stopped\": {stopped}\n}}\n"))?;
        }
        self.sink.finish()
    }
}

/// Appends a number that is finite.
fn append<A: Printable>(value: Option<&A::Value>, line: &mut String) {
    if let Some(value) = value.filter(|value| A::is_finite(value)) {
        A::append(value, line);
    }
}
