//! The columns of a sweep: what each means, in which unit, and the numbers of some rows.

use crate::plan::{Plan, Target};

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Integer,
    Double,
    Text,
}

/// A column.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    pub(crate) name: String,
    pub(crate) kind: Kind,
    /// What it is, with its unit.
    pub(crate) meaning: String,
}

impl Column {
    pub(crate) fn new(name: impl Into<String>, kind: Kind, meaning: impl Into<String>) -> Self {
        Self { name: name.into(), kind, meaning: meaning.into() }
    }
}

/// The entries of a column in some rows.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Entries {
    Integers(Vec<i64>),
    Doubles(Vec<f64>),
    Texts(Vec<String>),
}

/// One entry.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Entry {
    Integer(i64),
    Double(f64),
    Text(String),
}

/// Some rows, column by column.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rows {
    pub(crate) columns: Vec<Entries>,
}

impl Rows {
    /// No rows yet of these columns.
    pub(crate) fn of(columns: &[Column]) -> Self {
        let empty = |column: &Column| match column.kind {
            Kind::Integer => Entries::Integers(Vec::new()),
            Kind::Double => Entries::Doubles(Vec::new()),
            Kind::Text => Entries::Texts(Vec::new()),
        };
        Rows { columns: columns.iter().map(empty).collect() }
    }

    pub(crate) fn len(&self) -> usize {
        self.columns.first().map_or(0, |column| match column {
            Entries::Integers(entries) => entries.len(),
            Entries::Doubles(entries) => entries.len(),
            Entries::Texts(entries) => entries.len(),
        })
    }

    /// Adds an entry to a column of its kind.
    pub(crate) fn push(&mut self, column: usize, entry: Entry) {
        match (&mut self.columns[column], entry) {
            (Entries::Integers(entries), Entry::Integer(entry)) => entries.push(entry),
            (Entries::Doubles(entries), Entry::Double(entry)) => entries.push(entry),
            (Entries::Texts(entries), Entry::Text(entry)) => entries.push(entry),
            (column, entry) => unreachable!("{entry:?} in {column:?}"),
        }
    }

    /// Adds other rows behind these.
    pub(crate) fn append(&mut self, mut other: Rows) {
        for (to, from) in self.columns.iter_mut().zip(&mut other.columns) {
            match (to, from) {
                (Entries::Integers(to), Entries::Integers(from)) => to.append(from),
                (Entries::Doubles(to), Entries::Doubles(from)) => to.append(from),
                (Entries::Texts(to), Entries::Texts(from)) => to.append(from),
                (to, from) => unreachable!("{from:?} behind {to:?}"),
            }
        }
    }
}

/// Every column that a plan has: the index, the axes that vary, and what its task finds.
pub(crate) fn all(plan: &Plan) -> Vec<Column> {
    let index = Column::new("index", Kind::Integer, "place of the point in the plan, from 0 on");
    let axes = plan.axes.iter().filter(|axis| axis.varies()).map(|axis| {
        let kind =
            if matches!(axis.target, Target::Order | Target::Bits) { Kind::Integer } else { Kind::Double };
        Column::new(axis.name.clone(), kind, axis.meaning())
    });
    [index].into_iter().chain(axes).chain(plan.task.columns(plan)).collect()
}

/// The columns that are written, by their places among [`all`].
pub(crate) fn chosen(plan: &Plan) -> Vec<usize> {
    let all = all(plan);
    match &plan.columns {
        None => (0..all.len()).collect(),
        Some(names) => {
            names.iter().filter_map(|name| all.iter().position(|column| column.name == *name)).collect()
        }
    }
}

/// The columns that are written.
pub(crate) fn written(plan: &Plan) -> Vec<Column> {
    let all = all(plan);
    chosen(plan).into_iter().map(|place| all[place].clone()).collect()
}
