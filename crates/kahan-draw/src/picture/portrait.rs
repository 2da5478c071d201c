//! Phase portraits and sections of orbits in the plane or in space.

use std::collections::HashSet;
use std::ops::ControlFlow;

use kahan_latex::symbol;
use kahan_study::formula::Formula;
use kahan_study::{Column, Rows, Values};

use super::{COLOURS, Picture, PictureOptions};
use crate::plot::{Mark, NumberLine, Plot, Series, SpacePlot, SpaceSeries};

/// A coordinate that one axis shows.
#[derive(Clone, Debug)]
pub enum Coordinate {
    /// The time t = 2εn.
    Time,
    /// The variable with this index.
    Variable(usize),
    /// A formula in the variables and integrals.
    Formula {
        /// The text of the formula, or the name of an integral.
        text: String,
        /// The compiled formula.
        formula: Formula,
        /// The index of `t` among the formula's arguments, if the field depends on the time t.
        time: Option<usize>,
    },
}

/// The points of one orbit in the coordinates of two or three axes.
#[derive(Clone, Debug)]
pub struct Trace {
    axes: Vec<Coordinate>,
    columns: Vec<Vec<f64>>,
}

/// The number of points of an orbit. `places` counts points that lie close together only once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OrbitExtent {
    /// The number of points.
    pub points: usize,
    /// The number of distinguishable positions.
    pub places: usize,
}

impl Coordinate {
    /// Returns the name of the coordinate for a field with these variables.
    #[must_use]
    pub fn name<'a>(&'a self, variables: &'a [String]) -> &'a str {
        match self {
            Coordinate::Time => "t",
            Coordinate::Variable(index) => &variables[*index],
            Coordinate::Formula { text, .. } => text,
        }
    }

    /// Returns the coordinate at a point of an orbit at time t. The list `point` holds the
    /// variables and integrals.
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

    fn axis(
        &self,
        variables: &[String],
        values: impl Iterator<Item = f64>,
        look: &PictureOptions,
    ) -> NumberLine {
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
    /// Makes a trace without points. Panics unless there are two or three axes.
    #[must_use]
    pub fn new(axes: &[Coordinate]) -> Self {
        assert!(matches!(axes.len(), 2 | 3), "a portrait has two axes or three");
        Trace { axes: axes.to_vec(), columns: vec![Vec::new(); axes.len()] }
    }

    /// Returns the number of points.
    #[must_use]
    pub fn count(&self) -> usize {
        self.columns[0].len()
    }

    fn visits(&self, axes: &[NumberLine]) -> OrbitExtent {
        const PARTS: f64 = 200.0;

        let is_shown = |row: &usize| axes.iter().zip(&self.columns).all(|(axis, of)| axis.shows(of[*row]));
        let cell = |row: usize| -> [i64; 3] {
            let place = |(axis, of): (&NumberLine, &Vec<f64>)| axis.place(of[row], 0.0, PARTS).round() as i64;
            let mut places = axes.iter().zip(&self.columns).map(place);
            std::array::from_fn(|_| places.next().unwrap_or_default())
        };
        let cells: HashSet<[i64; 3]> = (0..self.count()).filter(is_shown).map(cell).collect();
        OrbitExtent { points: self.count(), places: cells.len() }
    }
}

impl Rows for Trace {
    /// Reads rows of n, t, the variables and the integrals.
    fn block(&mut self, _: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
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

/// Draws orbits of a field with these variables. Screen readers read the description. Panics if
/// `orbits` is empty.
#[must_use]
pub fn portrait(
    description: String,
    variables: &[String],
    orbits: Vec<Trace>,
    look: &PictureOptions,
) -> Picture {
    let axis = |(i, coordinate): (usize, &Coordinate)| {
        let values = orbits.iter().flat_map(|orbit| &orbit.columns[i]).copied();
        coordinate.axis(variables, values, look)
    };
    let axes: Vec<NumberLine> = orbits[0].axes.iter().enumerate().map(axis).collect();
    let visits: Vec<OrbitExtent> = orbits.iter().map(|orbit| orbit.visits(&axes)).collect();
    let marks = marks(&visits, look);
    let marked = orbits.into_iter().zip(marks).enumerate();
    let marked = marked.map(|(index, (orbit, mark))| (index % COLOURS + 1, mark, orbit.columns));
    let sheet = look.sheet;
    let picture = match <[NumberLine; 3]>::try_from(axes) {
        Ok(axes) => {
            let clouds = marked.map(|(colour, mark, columns)| {
                let points = (0..columns[0].len()).map(|i| std::array::from_fn(|axis| columns[axis][i]));
                SpaceSeries { colour, mark, points: points.collect() }
            });
            let space = SpacePlot { description, sheet, axes, clouds: clouds.collect() };
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

/// Chooses marks by the number of points. Orbits with few distinguishable positions get large dots.
fn marks(visits: &[OrbitExtent], look: &PictureOptions) -> Vec<Mark> {
    const FEW: usize = 24;
    /// Lines are thin if the orbits together have more points than this.
    const LINES: usize = 2000;

    let others = visits.iter().filter(|visits| visits.places > FEW);
    let points: usize = others.map(|visits| visits.points).sum();
    let mark = |visits: &OrbitExtent| match if visits.places <= FEW { 0 } else { points } {
        points if look.lines && points > LINES => Mark::Thin,
        _ if look.lines => Mark::Line,
        0..=400 => Mark::Dots,
        401..=20_000 => Mark::Points,
        _ => Mark::Fine,
    };
    visits.iter().map(mark).collect()
}
