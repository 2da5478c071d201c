//! Orbits in the plane or in space: all their points, or those of a section.

use std::collections::HashSet;
use std::ops::ControlFlow;

use kahan_latex::symbol;
use kahan_study::formula::Formula;
use kahan_study::{Column, Rows, Values};

use super::{COLOURS, Look, Picture};
use crate::plot::{Cloud, Mark, NumberLine, Plot, Series, Space};

/// What an axis shows of a point of an orbit.
#[derive(Clone, Debug)]
pub enum Coordinate {
    /// The time 2εn.
    Time,
    /// A variable, by its index.
    Variable(usize),
    /// A formula of all variables, and of the integrals behind them.
    Formula {
        /// Its text, or the name of an integral.
        text: String,
        /// The formula.
        formula: Formula,
        /// The place of `t` among the variables, where it is one and no column of the rows.
        time: Option<usize>,
    },
}

/// The points of an orbit, as two or three axes show them; it takes the rows of an orbit in doubles
/// and keeps no more of them than that.
#[derive(Clone, Debug)]
pub struct Trace {
    axes: Vec<Coordinate>,
    /// For each axis its coordinate of each point.
    columns: Vec<Vec<f64>>,
}

/// What is seen of an orbit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Visits {
    /// How many points it has in the picture.
    pub points: usize,
    /// At how many places these are that can be told apart.
    pub places: usize,
}

impl Coordinate {
    /// Its name, of a field with these variables.
    #[must_use]
    pub fn name<'a>(&'a self, variables: &'a [String]) -> &'a str {
        match self {
            Coordinate::Time => "t",
            Coordinate::Variable(index) => &variables[*index],
            Coordinate::Formula { text, .. } => text,
        }
    }

    /// Its value at a point: the time, and what follows it in rows.
    fn value(&self, t: f64, mut point: Vec<f64>) -> f64 {
        match self {
            Coordinate::Time => t,
            Coordinate::Variable(index) => point[*index],
            Coordinate::Formula { formula, time, .. } => {
                time.iter().for_each(|place| point.insert(*place, t));
                formula.of(&point)
            }
        }
    }

    /// An axis for these numbers.
    fn axis(&self, variables: &[String], values: impl Iterator<Item = f64>, look: &Look) -> NumberLine {
        let name = self.name(variables);
        look.windowed(
            name,
            match self {
                Coordinate::Time => NumberLine::around("t", values),
                Coordinate::Variable(_) => NumberLine::around_most(&symbol(name), values),
                Coordinate::Formula { text, .. } => NumberLine::around_most(text, values),
            },
        )
    }
}

impl Trace {
    /// Of no point yet.
    ///
    /// # Panics
    /// With other than two or three axes.
    #[must_use]
    pub fn new(axes: &[Coordinate]) -> Self {
        assert!(matches!(axes.len(), 2 | 3), "a portrait has two axes or three");
        Trace { axes: axes.to_vec(), columns: vec![Vec::new(); axes.len()] }
    }

    /// How many points there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.columns[0].len()
    }

    /// How often it is seen, and at how many places that can be told apart in a picture.
    fn visits(&self, axes: &[NumberLine]) -> Visits {
        /// Parts of an axis, about as wide as a small dot.
        const PARTS: f64 = 200.0;

        let is_shown = |row: &usize| axes.iter().zip(&self.columns).all(|(axis, of)| axis.shows(of[*row]));
        let cell = |row: usize| -> [i64; 3] {
            let place = |(axis, of): (&NumberLine, &Vec<f64>)| axis.place(of[row], 0.0, PARTS).round() as i64;
            let mut places = axes.iter().zip(&self.columns).map(place);
            std::array::from_fn(|_| places.next().unwrap_or_default())
        };
        let cells: HashSet<[i64; 3]> = (0..self.count()).filter(is_shown).map(cell).collect();
        Visits { points: self.count(), places: cells.len() }
    }
}

impl Rows for Trace {
    /// Takes rows of n, t, the variables, and whatever follows.
    fn block(&mut self, _: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        // The first column is the number of the step.
        let columns = values.iter().skip(1).map(|values| match values {
            Values::F64(values) => *values,
            _ => panic!("a picture shows doubles"),
        });
        let columns: Vec<&[f64]> = columns.collect();
        for (axis, column) in self.axes.iter().zip(&mut self.columns) {
            match axis {
                Coordinate::Time => column.extend_from_slice(columns[0]),
                Coordinate::Variable(index) => column.extend_from_slice(columns[1 + index]),
                Coordinate::Formula { .. } => column.extend((0..columns[0].len()).map(|row| {
                    axis.value(columns[0][row], columns[1..].iter().map(|column| column[row]).collect())
                })),
            }
        }
        ControlFlow::Continue(())
    }
}

/// Orbits of a field with these variables, their coordinates against each other. The description
/// says what is seen.
///
/// # Panics
/// Without an orbit.
#[must_use]
pub fn portrait(description: String, variables: &[String], orbits: Vec<Trace>, look: &Look) -> Picture {
    let axis = |(i, coordinate): (usize, &Coordinate)| {
        let values = orbits.iter().flat_map(|orbit| &orbit.columns[i]).copied();
        coordinate.axis(variables, values, look)
    };
    let axes: Vec<NumberLine> = orbits[0].axes.iter().enumerate().map(axis).collect();
    let visits: Vec<Visits> = orbits.iter().map(|orbit| orbit.visits(&axes)).collect();
    let marks = marks(&visits, look);
    let marked = orbits.into_iter().zip(marks).enumerate();
    let marked = marked.map(|(index, (orbit, mark))| (index % COLOURS + 1, mark, orbit.columns));
    let sheet = look.sheet;
    let picture = match <[NumberLine; 3]>::try_from(axes) {
        Ok(axes) => {
            let clouds = marked.map(|(colour, mark, columns)| {
                let points = (0..columns[0].len()).map(|i| std::array::from_fn(|axis| columns[axis][i]));
                Cloud { colour, mark, points: points.collect() }
            });
            let space = Space { description, sheet, axes, clouds: clouds.collect() };
            let points = visits.iter().map(|visits| visits.points).sum();
            Picture { drawing: space.drawing(), points, outside: space.outside(), visits: Vec::new() }
        }
        Err(axes) => {
            let series = marked.map(|(colour, mark, columns)| {
                let points = columns[0].iter().copied().zip(columns[1].iter().copied());
                Series::new("", colour, mark, points.collect())
            });
            let [x, y] = [&axes[0], &axes[1]].map(NumberLine::clone);
            Picture::of(&Plot { description, sheet, x, y, series: series.collect(), note: String::new() })
        }
    };
    Picture { visits, ..picture }
}

/// Marks by how many points there are, without those of orbits that always come back to the same
/// few places: these are drawn by dots that can be seen.
fn marks(visits: &[Visits], look: &Look) -> Vec<Mark> {
    const FEW: usize = 24;
    /// More points, joined by lines of the usual width, are an area.
    const LINES: usize = 2000;

    let others = visits.iter().filter(|visits| visits.places > FEW);
    let points: usize = others.map(|visits| visits.points).sum();
    let mark = |visits: &Visits| match if visits.places <= FEW { 0 } else { points } {
        points if look.lines && points > LINES => Mark::Thin,
        _ if look.lines => Mark::Line,
        0..=400 => Mark::Dots,
        401..=20_000 => Mark::Points,
        _ => Mark::Fine,
    };
    visits.iter().map(mark).collect()
}
