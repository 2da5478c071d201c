//! The rows of a result, on the cells of a chart.

use std::path::Path;

use crate::printing::Refusal;
use crate::reading::{self, Range, number};

/// What is drawn, and of which rows.
pub(super) struct Rows<'a> {
    pub(super) from: &'a Path,
    /// What is gone through: the name of a column, whose values are then the middles of the cells,
    /// or a range.
    pub(super) over: [&'a str; 2],
    /// The column that is shown.
    pub(super) column: String,
    /// NAME=VALUE: only the rows in which that column is that.
    pub(super) chosen: &'a [String],
}

/// The most cells of a chart.
const MOST_CELLS: usize = 1 << 26;

impl<'a> Rows<'a> {
    /// The cells, and the mean of what their rows show, row by row from below; not a number where
    /// there is none.
    pub(super) fn cells(&self, shown: impl Fn(f64) -> f64) -> Result<([Range<'a>; 2], Vec<f64>), Refusal> {
        let has_range = self.over.map(|over| over.contains('='));
        let names = self.over.map(|over| over.split_once('=').map_or(over, |(name, _)| name).trim());
        let chosen: Vec<(&str, f64)> =
            self.chosen.iter().map(|given| choice(given)).collect::<Result<_, _>>()?;
        let wanted: Vec<&str> = names
            .into_iter()
            .chain([self.column.as_str()])
            .chain(chosen.iter().map(|(name, _)| *name))
            .collect();
        let mut columns = reading::columns(self.from, &wanted, "--from")?;
        let conditions = columns.split_off(3);
        let is_chosen =
            |row: usize| conditions.iter().zip(&chosen).all(|(column, (_, value))| column[row] == *value);
        let rows: Vec<usize> = (0..columns[2].len()).filter(|row| is_chosen(*row)).collect();
        if rows.is_empty() {
            return Err(self.no_rows(&chosen, &conditions));
        }
        let range = |axis: usize| {
            if has_range[axis] {
                return Range::read(self.over[axis]);
            }
            let values: Vec<f64> = rows.iter().map(|row| columns[axis][*row]).collect();
            Range::around(names[axis], &values).ok_or_else(|| {
                let name = names[axis];
                Refusal::new(format!(
                    "--over {name}: the values of `{name}` are not equally spaced; give cells, as in --over {name}=-1:1:60"
                ))
            })
        };
        let ranges = [range(0)?, range(1)?];
        let [across, upwards] = ranges.each_ref().map(|range| range.steps);
        let count = across.checked_mul(upwards).filter(|count| *count <= MOST_CELLS);
        let count = count.ok_or_else(|| {
            Refusal::new(format!(
                "--over: {across} times {upwards} cells are too many; give fewer, as in --over {}=-1:1:600",
                names[0]
            ))
        })?;
        let mut cells = vec![Cell::default(); count];
        for row in rows {
            let places = [0, 1].map(|axis| ranges[axis].place(columns[axis][row]));
            let [Some(column), Some(line)] = places else { continue };
            cells[line * across + column].add(shown(columns[2][row]));
        }
        if let Some(place) =
            cells.iter().position(|cell| cell.rows > 1).filter(|_| !has_range.contains(&true))
        {
            let at = |axis: usize, index: usize| {
                ranges[axis].middles().nth(index).expect("the cell is one of the range")
            };
            return Err(Refusal::new(format!(
                "--over: {} rows have {} = {} and {} = {}; choose among them by another column, as in --where order=2, or give \
                 cells, as in --over {}=-1:1:60, which show the mean of their rows",
                cells[place].rows,
                names[0],
                at(0, place % across),
                names[1],
                at(1, place / across),
                names[0]
            )));
        }
        Ok((ranges, cells.into_iter().map(Cell::mean).collect()))
    }

    /// No row is in the file, or none is chosen.
    fn no_rows(&self, chosen: &[(&str, f64)], columns: &[Vec<f64>]) -> Refusal {
        const MOST: usize = 8;
        let there = chosen.iter().zip(columns).find(|((_, value), column)| !column.contains(value));
        Refusal::new(match there {
            None => format!("--from: no row of {} is chosen", self.from.display()),
            Some(((name, value), column)) => {
                let mut values = column.clone();
                values.sort_unstable_by(f64::total_cmp);
                values.dedup();
                let mut words: Vec<String> = values.iter().take(MOST).map(f64::to_string).collect();
                words.extend((values.len() > MOST).then(|| "…".to_owned()));
                format!("--where: no row has {name} = {value}; there is {}", words.join(", "))
            }
        })
    }
}

/// NAME=VALUE.
fn choice(given: &str) -> Result<(&str, f64), Refusal> {
    let Some((name, value)) = given.split_once('=') else {
        return Err(Refusal::new(format!("--where: `{given}` is not NAME=VALUE, as in --where order=2")));
    };
    Ok((name.trim(), number(value, "--where")?.to_f64()))
}

/// What the rows in a cell show.
#[derive(Clone, Copy, Debug, Default)]
struct Cell {
    rows: usize,
    /// Those that show a number, and their sum.
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
