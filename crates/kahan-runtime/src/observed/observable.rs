//! The names, columns and labels of observables, and the conversion of an observed value to one
//! number for each column.

use kahan_core::observe::{Drifted, Exponent, Extremes, RotationNumber};

use super::running::Observable;
use crate::PassedPoleCount;

#[derive(Clone, Copy, Debug)]
pub(super) struct ObservableInfo {
    pub(super) name: &'static str,
    of: ColumnScope,
    /// Names and meanings of the columns; `{}` is replaced by a variable, an integral or an index.
    columns: &'static [(&'static str, &'static str)],
    follows: ObservedPart,
    is_usual: bool,
    label: Option<&'static str>,
    is_logarithmic: bool,
}

/// The columns of an observable: of the whole orbit, or of each variable, integral or index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum ColumnScope {
    Orbit,
    Variables,
    Integrals,
    /// The indices from 1 to the number of variables, for example those of Lyapunov exponents.
    Numbers,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum ObservedPart {
    Points,
    TangentVectors,
    Map,
}

impl ObservableInfo {
    pub(super) const fn new(
        name: &'static str,
        of: ColumnScope,
        columns: &'static [(&'static str, &'static str)],
    ) -> Self {
        let (follows, is_usual, label, is_logarithmic) = (ObservedPart::Points, false, None, false);
        ObservableInfo { name, of, columns, follows, is_usual, label, is_logarithmic }
    }

    pub(super) const fn of_tangent_vectors(self) -> Self {
        ObservableInfo { follows: ObservedPart::TangentVectors, ..self }
    }

    pub(super) const fn of_the_map(self) -> Self {
        ObservableInfo { follows: ObservedPart::Map, ..self }
    }

    pub(super) const fn usual(self) -> Self {
        ObservableInfo { is_usual: true, ..self }
    }

    /// Lets charts colour orbits by the observable, which the legend calls `label`.
    pub(super) const fn colour(self, label: &'static str) -> Self {
        ObservableInfo { label: Some(label), ..self }
    }

    pub(super) const fn logarithmic(self) -> Self {
        ObservableInfo { is_logarithmic: true, ..self }
    }
}

/// The value of an observable at the end of an orbit.
#[derive(Clone, Debug, PartialEq)]
pub enum ObservedValue {
    /// The last point.
    Point(Vec<f64>),
    /// The drift of each integral, relative to its first value.
    Drift(Vec<Drifted>),
    /// The extremes of each variable; `None` if all values were NaN.
    Extrema(Vec<Option<Extremes<f64>>>),
    /// The largest Lyapunov exponent, with an estimate of its convergence.
    Exponent(Exponent),
    /// Lyapunov exponents in descending order.
    Spectrum(Vec<Exponent>),
    /// The value of the observable `LogDet`, `Fli`, `Megno` or `Sali`.
    Number(f64),
    /// The rotation of each variable, in full turns per step.
    Turns(Vec<RotationNumber>),
    /// The number of steps before the escape; `None` if the orbit did not escape.
    Step(Option<u64>),
    /// The number of steps in which the orbit passed a pole of the map.
    Passed(PassedPoleCount),
}

impl Observable {
    /// Returns the observable called `name`.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|one| one.name() == name)
    }

    /// Returns the observable called `name`, or otherwise the one with a column called `name`.
    #[must_use]
    pub fn of_column(name: &str) -> Option<Self> {
        let is_its = |(column, _): &(&str, &str)| match column.split_once("{}") {
            Some((start, _)) => name.starts_with(start),
            None => name == *column,
        };
        Self::named(name)
            .or_else(|| Self::ALL.iter().copied().find(|one| one.about().columns.iter().any(is_its)))
    }

    /// Returns the default observables.
    #[must_use]
    pub fn usual() -> Vec<Self> {
        Self::ALL.iter().copied().filter(|one| one.about().is_usual).collect()
    }

    /// Returns the name of the observable in requests.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.about().name
    }

    /// Returns the name in results. For an observable of the whole orbit, this is the name of its
    /// first column; for others, it is the name in requests.
    #[must_use]
    pub fn key(self) -> &'static str {
        let ObservableInfo { name, of, columns, .. } = self.about();
        if of == ColumnScope::Orbit { columns[0].0 } else { name }
    }

    /// Returns whether the observable needs tangent vectors.
    #[must_use]
    pub fn is_of_tangent_vectors(self) -> bool {
        self.about().follows == ObservedPart::TangentVectors
    }

    /// Returns whether the observable depends only on the points of the orbit.
    #[must_use]
    pub fn is_of_points(self) -> bool {
        self.about().follows == ObservedPart::Points
    }

    /// Returns the number of times that the orbit must be run.
    #[must_use]
    pub fn runs(self) -> u64 {
        if self == Self::Rotation { 2 } else { 1 }
    }

    /// Returns the label in a legend; `None` unless the observable can colour a chart.
    #[must_use]
    pub fn label(self) -> Option<&'static str> {
        self.about().label
    }

    /// Returns whether charts show the observable on a logarithmic scale.
    #[must_use]
    pub fn is_logarithmic(self) -> bool {
        self.about().is_logarithmic
    }

    /// Returns the columns (names and meanings) for a field with these variables and integrals.
    #[must_use]
    pub fn columns(self, variables: &[String], integrals: &[String]) -> Vec<(String, &'static str)> {
        let ObservableInfo { of, columns, .. } = self.about();
        let names = match of {
            ColumnScope::Orbit => vec![String::new()],
            ColumnScope::Variables => variables.to_vec(),
            ColumnScope::Integrals => integrals.to_vec(),
            ColumnScope::Numbers => (1..=variables.len()).map(|k| k.to_string()).collect(),
        };
        let each = |name: &String| {
            let named = columns.iter().map(|(column, meaning)| (column.replace("{}", name), *meaning));
            named.collect::<Vec<_>>()
        };
        names.iter().flat_map(each).collect()
    }
}

impl ObservedValue {
    /// Returns the numbers for the columns, in their order; NaN stands for a missing value.
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
            Self::Passed(PassedPoleCount { steps, is_lower_bound }) => {
                vec![*steps as f64, f64::from(u8::from(*is_lower_bound))]
            }
        }
    }
}
