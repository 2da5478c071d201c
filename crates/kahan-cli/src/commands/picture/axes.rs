//! The axes of a portrait: which numbers of an orbit they show, and from where to where.

use super::Subject;
use kahan_study::Plane;

use crate::printing::Refusal;
use crate::reading::number;
use kahan_draw::NumberLine;

/// What an axis shows of the point n.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Coordinate {
    /// The time 2εn.
    Time,
    /// A variable, by its index.
    Variable(usize),
}

impl Coordinate {
    /// The number, for a point that is `time` away from the first.
    pub(super) fn of(self, time: f64, x: &[f64]) -> f64 {
        match self {
            Coordinate::Time => time,
            Coordinate::Variable(i) => x[i],
        }
    }
}

impl Subject<'_> {
    /// The axes that were named; else all variables of up to three, or the first three; of a
    /// section the first two without the last that its formula names.
    pub(super) fn coordinates(&self, plane: Option<&Plane>) -> Result<Vec<Coordinate>, Refusal> {
        let named: Result<Vec<Coordinate>, Refusal> =
            self.asked.axes.iter().map(|name| self.coordinate(name.trim())).collect();
        let named = named?;
        Ok(match (named.len(), self.variables().len()) {
            (0, variables)
                if let Some(plane) = plane
                    && variables > 2 =>
            {
                let others = (0..variables).filter(|k| Some(*k) != plane.last_variable());
                others.take(2).map(Coordinate::Variable).collect()
            }
            (0, 1) => vec![Coordinate::Time, Coordinate::Variable(0)],
            (0, variables) => (0..variables.min(3)).map(Coordinate::Variable).collect(),
            (2 | 3, _) => named,
            (given, _) => {
                return Err(Refusal::new(format!(
                    "--axes: a portrait has two axes or three, as in --axes x,y, and {given} given"
                )));
            }
        })
    }

    /// The variable of this name, or the time where no variable is called t.
    pub(super) fn coordinate(&self, name: &str) -> Result<Coordinate, Refusal> {
        match self.variables().iter().position(|known| known == name) {
            Some(index) => Ok(Coordinate::Variable(index)),
            None if name == "t" => Ok(Coordinate::Time),
            None => Err(Refusal::new(format!(
                "--axes: `{name}` is no variable of {}: it has {}; t is the time",
                self.name,
                self.variables().join(", ")
            ))),
        }
    }

    /// The name by which the command line knows an axis.
    pub(super) fn axis_name(&self, coordinate: Coordinate) -> &str {
        match coordinate {
            Coordinate::Time => "t",
            Coordinate::Variable(index) => &self.variables()[index],
        }
    }

    /// An axis for these numbers.
    pub(super) fn axis(
        &self,
        coordinate: Coordinate,
        values: impl Iterator<Item = f64>,
    ) -> Result<NumberLine, Refusal> {
        let name = self.axis_name(coordinate);
        match coordinate {
            Coordinate::Time => self.windowed(name, NumberLine::around("t, in units of time", values)),
            Coordinate::Variable(_) => self.windowed(name, NumberLine::around_most(name, values)),
        }
    }

    /// The axis, with the ends that `--window` gives it.
    pub(super) fn windowed(&self, name: &str, line: NumberLine) -> Result<NumberLine, Refusal> {
        let given = self.asked.window.iter().map(|window| (window, window.split_once('=')));
        let mut ends = given.filter(|(_, parts)| parts.is_some_and(|(known, _)| known.trim() == name));
        let Some((window, Some((_, range)))) = ends.next() else { return Ok(line) };
        let wrong = || {
            Refusal::new(format!(
                "--window: `{window}` is not NAME=LOW:HIGH with LOW below HIGH, as in {name}=-2:2"
            ))
        };
        let (low, high) = range.split_once(':').ok_or_else(wrong)?;
        let (low, high) = (number(low, "--window")?.to_f64(), number(high, "--window")?.to_f64());
        if !(low.is_finite() && high.is_finite() && low < high) {
            return Err(wrong());
        }
        Ok(NumberLine { low, high, ..line })
    }

    /// Refuses a window of an axis that the picture does not have.
    pub(super) fn check_windows(&self, axes: &[&str]) -> Result<(), Refusal> {
        let names =
            self.asked.window.iter().map(|window| window.split('=').next().unwrap_or_default().trim());
        match names.into_iter().find(|name| !axes.contains(name)) {
            None => Ok(()),
            Some(name) => Err(Refusal::new(format!(
                "--window: the picture has no axis `{name}`; it has {}",
                axes.join(", ")
            ))),
        }
    }
}
