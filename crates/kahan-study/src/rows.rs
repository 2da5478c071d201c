//! Answers that are tables, handed on in blocks while they are made, so that the length of a table
//! costs no memory.

use std::ops::ControlFlow;

use kahan_algebra::rational::Rational;
use kahan_core::Dd;

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its name; all names of a table differ.
    pub name: String,
    /// What its numbers mean, with their unit.
    pub meaning: String,
}

/// Consecutive values of a column. Of floats, what has no value is not a number.
#[derive(Clone, Copy, Debug)]
pub enum Values<'a> {
    /// In double precision.
    F64(&'a [f64]),
    /// In single precision.
    F32(&'a [f32]),
    /// In double-double.
    Dd(&'a [Dd]),
    /// Exact numbers.
    Exact(&'a [Exact]),
    /// Counts.
    Integer(&'a [i64]),
    /// Words and formulas.
    Text(&'a [String]),
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
