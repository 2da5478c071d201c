//! Tables that are written row by row, as CSV or as the rows of a JSON object.

use std::ops::ControlFlow;

use kahan_study::{Cell, Column, Rows, StoredColumn, Values, csv_line};
use serde_json::{Map, Value};

use super::layout::{after_commas, terminal_width};
use super::output_stream::{OutputStream, WriteError};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// Comma-separated values below a line of column names. Undefined values are empty.
    Csv,
    /// One JSON object with the rows as the member `rows`. Undefined values are null.
    Json,
}

pub(crate) struct Table {
    sink: OutputStream,
    format: Format,
    /// The cells at the beginning of each row, which identify the orbit.
    place: Vec<StoredColumn>,
    line: String,
    has_rows: bool,
    width: Option<usize>,
    broken: Option<WriteError>,
    /// Whether rows are computed even if the reader has closed the pipe.
    outlives_reader: bool,
}

impl Table {
    /// Writes the head of a table. The names of the columns are the member `columns` of `head`.
    pub(crate) fn begin(
        sink: OutputStream,
        format: Format,
        head: &Map<String, Value>,
    ) -> Result<Self, WriteError> {
        let width = terminal_width().filter(|_| sink.is_standard() && format == Format::Csv);
        let text = match format {
            Format::Csv => {
                let columns = head.get("columns").and_then(Value::as_array).into_iter().flatten();
                let mut line = String::new();
                csv_line(&mut line, columns.filter_map(Value::as_str));
                width.map_or_else(|| line.clone(), |width| after_commas(&line, width))
            }
            Format::Json => {
                let entries =
                    head.iter().map(|(key, value)| format!("  {}: {value},\n", Value::from(key.as_str())));
                format!("{{\n{}  \"rows\": [", entries.collect::<String>())
            }
        };
        let (line, place, broken) = (String::new(), Vec::new(), None);
        let mut table =
            Table { sink, format, place, line, has_rows: false, width, broken, outlives_reader: false };
        table.sink.write(&text)?;
        Ok(table)
    }

    /// Begins an orbit, whose rows all start with the cells in `place`.
    pub(crate) fn begin_orbit(&mut self, place: Vec<StoredColumn>) {
        self.place = place;
    }

    pub(crate) fn continue_without_reader(&mut self, does: bool) {
        self.outlives_reader = does;
    }

    fn row<'a>(&mut self, cells: impl Iterator<Item = Cell<'a>>) -> Result<(), WriteError> {
        self.line.clear();
        match self.format {
            Format::Csv => csv_line(&mut self.line, cells),
            Format::Json => {
                self.line.push_str(if self.has_rows { ",\n    " } else { "\n    " });
                let row = serde_json::to_string(&cells.collect::<Vec<_>>());
                self.line.push_str(&row.expect("cells are JSON"));
            }
        }
        self.has_rows = true;
        match self.width {
            Some(width) if self.line.len() > width => self.sink.write(after_commas(&self.line, width)),
            _ => self.sink.write(&self.line),
        }
    }

    pub(crate) fn written(&mut self) -> Result<(), WriteError> {
        self.broken.take().map_or(Ok(()), Err)
    }

    /// Writes the members `behind`, which follow the rows, and closes the output stream.
    pub(crate) fn end(mut self, behind: &Map<String, Value>) -> Result<(), WriteError> {
        if self.format == Format::Json {
            self.sink.write("\n  ]")?;
            for (name, value) in behind {
                self.sink.write(format!(",\n  \"{name}\": {value}"))?;
            }
            self.sink.write("\n}\n")?;
        }
        self.sink.finish()
    }
}

impl Rows for Table {
    fn block(&mut self, _: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        let count = values.first().map_or(0, Values::count);
        let place = std::mem::take(&mut self.place);
        let written = (0..count).try_for_each(|row| {
            let first = place.iter().map(|kept| kept.values().cell(0));
            self.row(first.chain(values.iter().map(|values| values.cell(row))))
        });
        self.place = place;
        match written {
            Err(WriteError::ReaderGone) if self.outlives_reader => ControlFlow::Continue(()),
            Err(broken) => {
                self.broken = Some(broken);
                ControlFlow::Break(())
            }
            Ok(()) => ControlFlow::Continue(()),
        }
    }
}
