//! Tables that are computed and passed on in blocks of rows, so that memory is bounded.

use std::fmt::{self, Display, Write};
use std::ops::{ControlFlow, Range};

use kahan_algebra::rational::Rational;
use kahan_core::Dd;
use kahan_runtime::{End, Fraction};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use crate::error::{Spelling, by_name};
use crate::numbers::Number;

/// The most cells that an answer may hold in memory.
pub const MOST_CELLS: u64 = 1 << 24;

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// The name, unique in the table.
    pub name: String,
    /// The meaning of the numbers, with their unit.
    pub meaning: String,
}

/// Appends `_` to a name until it differs from all `others`.
#[must_use]
pub fn free_name(others: &[impl AsRef<str>], name: &str) -> String {
    let mut name = name.to_owned();
    while others.iter().any(|other| other.as_ref() == name) {
        name.push('_');
    }
    name
}

macro_rules! kinds {
    ($($(#[$about:meta])* $kind:ident($value:ident: $of:ty) => $cell:expr;)*) => {
        /// Consecutive values of a column. Float columns hold NaN for an undefined value, and
        /// infinity for a coordinate of a point at infinity.
        #[derive(Clone, Copy, Debug)]
        pub enum Values<'a> {
            $($(#[$about])* $kind(&'a [$of]),)*
        }

        /// The values of a column in memory.
        #[derive(Clone, Debug, PartialEq)]
        pub enum StoredColumn {
            $($(#[$about])* $kind(Vec<$of>),)*
        }

        impl<'a> Values<'a> {
            /// Returns the number of values.
            #[must_use]
            pub fn count(&self) -> usize {
                match self {
                    $(Self::$kind(list) => list.len(),)*
                }
            }

            /// Returns the value in a row. Panics if `row` is out of range.
            #[must_use]
            pub fn cell(&self, row: usize) -> Cell<'a> {
                match self {
                    $(Self::$kind(list) => {
                        let $value = &list[row];
                        $cell
                    })*
                }
            }

            pub(crate) fn part(&self, rows: Range<usize>) -> Values<'a> {
                match self {
                    $(Self::$kind(list) => Values::$kind(&list[rows]),)*
                }
            }

            fn to_kept(self) -> StoredColumn {
                match self {
                    $(Self::$kind(list) => StoredColumn::$kind(list.to_vec()),)*
                }
            }
        }

        impl StoredColumn {
            /// Returns the values as slices.
            #[must_use]
            pub fn values(&self) -> Values<'_> {
                match self {
                    $(Self::$kind(list) => Values::$kind(list),)*
                }
            }

            fn extend(&mut self, more: &Values<'_>) {
                match (self, more) {
                    $((Self::$kind(list), Values::$kind(more)) => list.extend_from_slice(more),)*
                    _ => unreachable!("the blocks of a column are of one kind"),
                }
            }
        }
    };
}

kinds! {
    /// Double precision.
    F64(value: f64) => Cell::Float(Number::F64(*value));
    /// Single precision.
    F32(value: f32) => Cell::Float(Number::F32(*value));
    /// Double-double.
    Dd(value: Dd) => Cell::Float(Number::Dd(*value));
    /// Exact numbers.
    Exact(value: Exact) => Cell::Exact(value);
    /// Counts.
    Integer(value: i64) => Cell::Integer(*value);
    /// Words and formulas.
    Text(value: String) => Cell::Text(value);
}

/// An exact value, possibly infinite or undefined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Exact {
    /// A number in lowest terms.
    Number(Fraction),
    /// A coordinate of a point at infinity, without sign.
    Infinite,
    /// An undefined value.
    Undefined,
}

/// A cell of a table. CSV has `inf` for an infinite value and an empty cell for an undefined
/// value; JSON has `null` for both.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell<'a> {
    /// A float.
    Float(Number),
    /// An exact value.
    Exact(&'a Exact),
    /// A count.
    Integer(i64),
    /// A word or a formula.
    Text(&'a str),
}

impl Cell<'_> {
    /// Returns the nearest double, or NaN if the cell is not a finite number.
    pub(crate) fn to_f64(&self) -> f64 {
        match self {
            Self::Float(number) => number.to_f64(),
            Self::Exact(Exact::Number(number)) => Rational::from(number).to_f64(),
            Self::Integer(count) => *count as f64,
            Self::Exact(_) | Self::Text(_) => f64::NAN,
        }
    }
}

impl Display for Cell<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Float(number) if number.is_finite() => number.fmt(f),
            Self::Float(number) if !number.is_nan() => f.write_str("inf"),
            Self::Float(_) | Self::Exact(Exact::Undefined) => Ok(()),
            Self::Exact(Exact::Number(number)) => number.fmt(f),
            Self::Exact(Exact::Infinite) => f.write_str("inf"),
            Self::Integer(count) => count.fmt(f),
            Self::Text(text) => f.write_str(text),
        }
    }
}

/// Appends a line of CSV to a text, without adding quotes.
pub fn csv_line(text: &mut String, cells: impl IntoIterator<Item = impl Display>) {
    for (place, cell) in cells.into_iter().enumerate() {
        let comma = if place == 0 { "" } else { "," };
        write!(text, "{comma}{cell}").expect("a string takes all text");
    }
    text.push('\n');
}

impl Serialize for Cell<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Float(number) => number.serialize(serializer),
            Self::Exact(Exact::Number(number)) => serializer.collect_str(number),
            Self::Exact(_) => serializer.serialize_none(),
            Self::Integer(count) => count.serialize(serializer),
            Self::Text(text) => text.serialize(serializer),
        }
    }
}

/// A consumer of the rows of a table, block by block.
pub trait Rows {
    /// Takes a block of rows: the values of each column, all of one length. Returns `Break` to end
    /// the work.
    fn block(&mut self, columns: &[Column], values: &[Values<'_>]) -> ControlFlow<()>;
}

/// A table in memory, which serializes as a list of rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The columns; empty before the first block.
    pub columns: Vec<Column>,
    /// The values of each column.
    pub values: Vec<StoredColumn>,
}

impl Table {
    /// Returns the number of rows.
    #[must_use]
    pub fn count(&self) -> usize {
        self.values.first().map_or(0, |first| first.values().count())
    }

    /// Passes the whole table on as one block.
    pub fn pass_to(&self, rows: &mut dyn Rows) -> ControlFlow<()> {
        rows.block(&self.columns, &self.values.iter().map(StoredColumn::values).collect::<Vec<_>>())
    }
}

impl Rows for Table {
    fn block(&mut self, columns: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        if self.columns.is_empty() {
            self.columns = columns.to_vec();
            self.values = values.iter().map(|values| values.to_kept()).collect();
        } else {
            self.values.iter_mut().zip(values).for_each(|(kept, more)| kept.extend(more));
        }
        ControlFlow::Continue(())
    }
}

impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let row = |row| self.values.iter().map(|kept| kept.values().cell(row)).collect::<Vec<_>>();
        serializer.collect_seq((0..self.count()).map(row))
    }
}

/// The reason why the rows of an orbit ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ending {
    /// The kind of the end.
    pub end: End,
    /// The number of steps to the last point; all steps if the orbit is complete.
    pub step: u64,
    /// A sentence on why no next point exists; `None` for a complete or interrupted orbit.
    pub why: Option<String>,
    /// The name and the value of an option with which the orbit might not end here.
    pub instead: Option<[&'static str; 2]>,
    /// A remark about the orbit, unrelated to its end, as a sentence.
    pub note: Option<String>,
}

impl Ending {
    pub(crate) fn plain(end: End, step: u64) -> Self {
        Ending { end, step, why: None, instead: None, note: None }
    }

    /// Returns the reason why the orbit ended, and an option that may help, written by `spelling`.
    #[must_use]
    pub fn in_words(&self, spelling: Spelling) -> Option<String> {
        let instead = self.instead.map(|[name, value]| format!("; try {}", spelling(name, value)));
        Some(self.why.clone()? + &instead.unwrap_or_default())
    }
}

/// Writes the name of the end, the step, the reason, and a note if there is one.
impl Serialize for Ending {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("Ending", 3 + usize::from(self.note.is_some()))?;
        object.serialize_field("ended", self.end.name())?;
        object.serialize_field("ended_step", &self.step)?;
        object.serialize_field("stopped", &self.in_words(by_name))?;
        match &self.note {
            Some(note) => object.serialize_field("note", note)?,
            None => object.skip_field("note")?,
        }
        object.end()
    }
}
