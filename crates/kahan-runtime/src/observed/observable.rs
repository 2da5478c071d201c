//! What is said of an observable: its name, the columns of a table that hold it, and its place in
//! answers and charts; and what was seen as numbers of these columns.
//!
//! The list of observables is in its neighbour `running`, with the observers.

use kahan_core::observe::{Drifted, Exponent, Extremes, Turns};

use super::running::Observable;
use crate::Passed;

/// What an observable says of itself.
#[derive(Clone, Copy, Debug)]
pub(super) struct About {
    pub(super) name: &'static str,
    of: Of,
    /// Names with `{}` for the part of the orbit that they are of, and meanings.
    columns: &'static [(&'static str, &'static str)],
    follows: Follows,
    is_usual: bool,
    label: Option<&'static str>,
    is_logarithmic: bool,
}

/// The parts of an orbit that have columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Of {
    /// The orbit as a whole.
    Orbit,
    /// Each variable.
    Variables,
    /// Each integral.
    Integrals,
    /// Each number from 1 up to that of the variables.
    Numbers,
}

/// What an observer needs beside the points.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Follows {
    Points,
    TangentVectors,
    Map,
}

impl About {
    /// An observable of points, by its name in questions and its columns.
    pub(super) const fn new(
        name: &'static str,
        of: Of,
        columns: &'static [(&'static str, &'static str)],
    ) -> Self {
        let (follows, is_usual, label, is_logarithmic) = (Follows::Points, false, None, false);
        About { name, of, columns, follows, is_usual, label, is_logarithmic }
    }

    /// Follows tangent vectors.
    pub(super) const fn of_tangent_vectors(self) -> Self {
        About { follows: Follows::TangentVectors, ..self }
    }

    /// Asks the map at each point.
    pub(super) const fn of_the_map(self) -> Self {
        About { follows: Follows::Map, ..self }
    }

    /// Is observed unless others are named.
    pub(super) const fn usual(self) -> Self {
        About { is_usual: true, ..self }
    }

    /// Colours charts, whose legend has this label.
    pub(super) const fn colour(self, label: &'static str) -> Self {
        About { label: Some(label), ..self }
    }

    /// Is charted as its logarithm.
    pub(super) const fn logarithmic(self) -> Self {
        About { is_logarithmic: true, ..self }
    }
}

/// What was seen.
#[derive(Clone, Debug, PartialEq)]
pub enum Seen {
    /// The last point.
    Point(Vec<f64>),
    /// How far each integral drifted, relative to its first value.
    Drift(Vec<Drifted>),
    /// The extremes of each variable; `None` where no value was a number.
    Extrema(Vec<Option<Extremes<f64>>>),
    /// The largest exponent, with how far it has converged.
    Exponent(Exponent),
    /// All exponents, in descending order.
    Spectrum(Vec<Exponent>),
    /// An indicator.
    Number(f64),
    /// Turns a step of each variable.
    Turns(Vec<Turns>),
    /// The step of the escape.
    Step(Option<u64>),
    /// The steps over poles.
    Passed(Passed),
}

impl Observable {
    /// Returns the observable of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|one| one.name() == name)
    }

    /// Returns the observable with a column of this name, or of this name itself.
    #[must_use]
    pub fn of_column(name: &str) -> Option<Self> {
        let is_its = |(column, _): &(&str, &str)| match column.split_once("{}") {
            Some((start, _)) => name.starts_with(start),
            None => name == *column,
        };
        Self::named(name)
            .or_else(|| Self::ALL.iter().copied().find(|one| one.about().columns.iter().any(is_its)))
    }

    /// Returns the observables where none are named.
    #[must_use]
    pub fn usual() -> Vec<Self> {
        Self::ALL.iter().copied().filter(|one| one.about().is_usual).collect()
    }

    /// Its name in questions.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.about().name
    }

    /// Its name in answers: that of its first column, where the orbit as a whole has one.
    #[must_use]
    pub fn key(self) -> &'static str {
        let About { name, of, columns, .. } = self.about();
        if of == Of::Orbit { columns[0].0 } else { name }
    }

    /// Whether it follows tangent vectors, which are those of the original variables where a field was
    /// lifted.
    #[must_use]
    pub fn is_of_tangent_vectors(self) -> bool {
        self.about().follows == Follows::TangentVectors
    }

    /// Whether it needs the points of an orbit alone, by whatever steps they are made.
    #[must_use]
    pub fn is_of_points(self) -> bool {
        self.about().follows == Follows::Points
    }

    /// How often the orbit is followed.
    #[must_use]
    pub fn runs(self) -> u64 {
        if self == Self::Rotation { 2 } else { 1 }
    }

    /// Its label in charts, where they show it.
    #[must_use]
    pub fn label(self) -> Option<&'static str> {
        self.about().label
    }

    /// Whether charts show its logarithm.
    #[must_use]
    pub fn is_logarithmic(self) -> bool {
        self.about().is_logarithmic
    }

    /// The columns of a table that hold it, of a field with these variables and integrals: names
    /// and meanings.
    #[must_use]
    pub fn columns(self, variables: &[String], integrals: &[String]) -> Vec<(String, &'static str)> {
        let About { of, columns, .. } = self.about();
        let names = match of {
            Of::Orbit => vec![String::new()],
            Of::Variables => variables.to_vec(),
            Of::Integrals => integrals.to_vec(),
            Of::Numbers => (1..=variables.len()).map(|k| k.to_string()).collect(),
        };
        let each = |name: &String| {
            let named = columns.iter().map(|(column, meaning)| (column.replace("{}", name), *meaning));
            named.collect::<Vec<_>>()
        };
        names.iter().flat_map(each).collect()
    }
}

impl Seen {
    /// The numbers of the columns, in their order; what there is none of is not a number.
    #[must_use]
    pub fn numbers(&self) -> Vec<f64> {
        match self {
            Self::Point(point) => point.clone(),
            Self::Drift(drifts) => drifts.iter().flat_map(|drifted| [drifted.max, drifted.last]).collect(),
            Self::Extrema(extrema) => {
                let ends =
                    |of: &Option<Extremes<f64>>| of.map_or([f64::NAN; 2], |of| [of.least, of.greatest]);
                extrema.iter().flat_map(ends).collect()
            }
            Self::Exponent(exponent) => vec![exponent.value, exponent.error],
            Self::Spectrum(exponents) => exponents.iter().map(|exponent| exponent.value).collect(),
            Self::Number(number) => vec![*number],
            Self::Turns(turns) => turns.iter().flat_map(|turns| [turns.value, turns.error]).collect(),
            Self::Step(step) => vec![step.map_or(f64::NAN, |step| step as f64)],
            Self::Passed(Passed { steps, is_lower_bound }) => {
                vec![*steps as f64, f64::from(u8::from(*is_lower_bound))]
            }
        }
    }
}
