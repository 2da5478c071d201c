//! Reads rows of numbers from a file, and averages them over the cells of a chart.

use std::path::Path;

use kahan_study::{Axis, Range};

use crate::printing::{UsageError, joined};
use crate::reading::{self, named, number, over};

/// A column of a file, restricted to the rows that are drawn.
pub(super) struct Rows<'a> {
    pub(super) from: &'a Path,
    /// The axes: ranges, or names of columns whose values are the midpoints of the cells.
    pub(super) over: &'a [String],
    pub(super) column: String,
    pub(super) chosen: &'a [String],
}

const MOST_DRAWN: usize = 1 << 26;

impl<'a> Rows<'a> {
    /// Returns the axes and the mean value in each cell, bottom row first. Empty cells are NaN.
    pub(super) fn cells(&self, shown: impl Fn(f64) -> f64) -> Result<(Vec<Axis>, Vec<f64>), UsageError> {
        let axes = 0..self.over.len();
        let name = |over: &'a String| over.split_once('=').map_or(&**over, |(name, _)| name).trim();
        let names: Vec<&str> = self.over.iter().map(name).collect();
        let has_range = |axis: usize| self.over[axis].contains('=');
        let chosen: Vec<(&str, f64)> =
            self.chosen.iter().map(|given| choice(given)).collect::<Result<_, _>>()?;
        let wanted = names.iter().copied().chain([self.column.as_str()]);
        let wanted: Vec<&str> = wanted.chain(chosen.iter().map(|(name, _)| *name)).collect();
        let mut columns = reading::columns(self.from, &wanted, "--from")?;
        let conditions = columns.split_off(axes.len() + 1);
        let values = columns.pop().expect("the column that is shown");
        let is_chosen =
            |row: usize| conditions.iter().zip(&chosen).all(|(column, (_, value))| column[row] == *value);
        let rows: Vec<usize> = (0..values.len()).filter(|row| is_chosen(*row)).collect();
        if rows.is_empty() {
            return Err(self.no_rows(&chosen, &conditions));
        }
        let range = |axis: usize| {
            if has_range(axis) {
                return over(&self.over[axis]);
            }
            let values: Vec<f64> = rows.iter().map(|row| columns[axis][*row]).collect();
            let name = names[axis];
            let range = Range::around(&values).ok_or_else(|| {
                UsageError::new(format!(
                    "--over {name}: the values of `{name}` are not equally spaced; give cells, as in --over {name}=-1:1:/60"
                ))
            })?;
            Ok(Axis { name: name.to_owned(), range })
        };
        let ranges: Vec<Axis> = axes.clone().map(range).collect::<Result<_, _>>()?;
        let counts: Vec<usize> = ranges.iter().map(|axis| axis.range.count()).collect();
        let count = counts.iter().try_fold(1_usize, |count, own| count.checked_mul(*own));
        let count = count.filter(|count| *count <= MOST_DRAWN).ok_or_else(|| {
            let counts = joined(&counts, " times ");
            UsageError::new(format!(
                "--over: {counts} cells are too many, and at most {MOST_DRAWN} are drawn; give fewer, as in --over {}=-1:1:/600",
                names[0]
            ))
        })?;
        let mut cells = vec![Cell::default(); count];
        for row in rows {
            let place = |axis: usize| ranges[axis].range.place(columns[axis][row]);
            let cell = axes.clone().rev().try_fold(0, |cell, axis| Some(cell * counts[axis] + place(axis)?));
            if let Some(cell) = cell {
                cells[cell].add(shown(values[row]));
            }
        }
        let shared = cells.iter().position(|cell| cell.rows > 1);
        if let Some(cell) = shared.filter(|_| !axes.clone().any(has_range)) {
            let places = [cell % counts[0], cell / counts[0]];
            let at = ranges.iter().zip(places);
            let at = at.map(|(axis, place)| format!("{} = {}", axis.name, axis.range.value(place)));
            return Err(UsageError::new(format!(
                "--over: {} rows have {}; choose among them by another column, as in --where order=2, or give cells, as in \
                 --over {}=-1:1:/60, which show the mean of their rows",
                cells[cell].rows,
                joined(at, " and "),
                names[0]
            )));
        }
        Ok((ranges, cells.into_iter().map(Cell::mean).collect()))
    }

    fn no_rows(&self, chosen: &[(&str, f64)], columns: &[Vec<f64>]) -> UsageError {
        const MOST: usize = 8;
        let there = chosen.iter().zip(columns).find(|((_, value), column)| !column.contains(value));
        UsageError::new(match there {
            None => format!("--from: no row of {} is chosen", self.from.display()),
            Some(((name, value), column)) => {
                let mut values = column.clone();
                values.sort_unstable_by(f64::total_cmp);
                values.dedup();
                let more = if values.len() > MOST { ", …" } else { "" };
                let values = joined(values.iter().take(MOST), ", ");
                format!("--where: no row has {name} = {value}; there is {values}{more}")
            }
        })
    }
}

fn choice(given: &str) -> Result<(&str, f64), UsageError> {
    let (name, value) = named(given, "--where", "order=2")?;
    Ok((name, number(value, "--where")?.to_f64()))
}

#[derive(Clone, Copy, Debug, Default)]
struct Cell {
    rows: usize,
    numbers: usize,
    sum: f64,
}

impl Cell {
    fn add(&mut self, value: f64) {
        self.rows += 1;
        if !value.is_nan() {
            self.numbers += 1;
            self.sum += value;
        }
    }

    fn mean(self) -> f64 {
        self.sum / self.numbers as f64
    }
}
