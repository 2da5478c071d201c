//! Answers that are tables, handed on in blocks while they are made, so that the length of a table
//! costs no memory.

use std::ops::ControlFlow;

use kahan_algebra::rational::Rational;
use kahan_core::Dd;
use serde::{Serialize, Serializer};
use serde_json::{Value, json};

use crate::numbers::Number;

/// The most cells that an answer keeps in memory.
pub const MOST_CELLS: u64 = 1 << 24;

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its name; all names of a table differ.
    pub name: String,
    /// What its numbers mean, with their unit.
    pub meaning: String,
}

macro_rules! kinds {
    ($($(#[$about:meta])* $kind:ident($one:ident: $value:ty) => $cell:expr;)*) => {
        /// Consecutive values of a column. Of floats, what has no value is not a number.
        #[derive(Clone, Copy, Debug)]
        pub enum Values<'a> {
            $($(#[$about])* $kind(&'a [$value]),)*
        }

        /// The values of a column in memory.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Kept {
            $($(#[$about])* $kind(Vec<$value>),)*
        }

        impl Values<'_> {
            /// How many there are.
            #[must_use]
            pub fn count(&self) -> usize {
                match self {
                    $(Self::$kind(list) => list.len(),)*
                }
            }

            /// The one of a row, in JSON.
            fn cell(&self, row: usize) -> Value {
                match self {
                    $(Self::$kind(list) => {
                        let $one = &list[row];
                        json!($cell)
                    })*
                }
            }

            fn to_kept(self) -> Kept {
                match self {
                    $(Self::$kind(list) => Kept::$kind(list.to_vec()),)*
                }
            }
        }

        impl Kept {
            /// The values.
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
    /// In double precision.
    F64(value: f64) => Number::F64(*value);
    /// In single precision.
    F32(value: f32) => Number::F32(*value);
    /// In double-double.
    Dd(value: Dd) => Number::Dd(*value);
    /// Exact numbers.
    Exact(value: Exact) => match value { Exact::Number(value) => Some(value.to_string()), _ => None };
    /// Counts.
    Integer(value: i64) => value;
    /// Words and formulas.
    Text(value: String) => value;
}

/// An exact value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Exact {
    /// A number.
    Number(Rational),
    /// A coordinate of a point at infinity, which has no sign.
    Infinite,
    /// There is no value.
    Undefined,
}

/// Takes the rows of a table, a block after the other.
pub trait Rows {
    /// Takes some thousand rows at most: for each column its values, all of one length. `Break`
    /// ends the work; no more blocks come.
    fn block(&mut self, columns: &[Column], values: &[Values<'_>]) -> ControlFlow<()>;
}

/// A table in memory, which takes all rows that come.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The columns; none before the first block.
    pub columns: Vec<Column>,
    /// For each column its values.
    pub values: Vec<Kept>,
}

impl Table {
    /// How many rows it has.
    #[must_use]
    pub fn count(&self) -> usize {
        self.values.first().map_or(0, |first| first.values().count())
    }

    /// Hands all of it on as one block.
    pub fn hand_to(&self, rows: &mut dyn Rows) -> ControlFlow<()> {
        rows.block(&self.columns, &self.values.iter().map(Kept::values).collect::<Vec<_>>())
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

/// A list of rows.
impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let row = |row| self.values.iter().map(|kept| kept.values().cell(row)).collect::<Vec<_>>();
        serializer.collect_seq((0..self.count()).map(row))
    }
}

/// How a table ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// All rows that were asked for are there.
    Complete,
    /// The map has a pole after so many steps.
    Pole(u64),
    /// Numbers left the range of the scalar after so many steps.
    Range(u64),
    /// The time was up.
    Time,
    /// The watch, or who took the rows, stopped the work.
    Stopped,
}
