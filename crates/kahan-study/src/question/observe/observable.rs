//! What can be observed of an orbit, by name, with the columns of a table that hold it.
//!
//! In: names. Out: names, columns, and what was seen as numbers of these columns. Which observer
//! finds what, its neighbour `running` knows.

use kahan_core::observe::{Drifted, Exponent, Extremes, Turns};
use serde::{Deserialize, Serialize};

use crate::rows::Column;

macro_rules! observables {
    ($($name:ident, called $text:literal: $meaning:literal;)*) => {
        /// What can be observed of an orbit.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
        pub enum Observable {
            $(#[doc = $meaning] #[serde(rename = $text)] $name,)*
        }

        impl Observable {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// Its name in questions.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$name => $text,)*
                }
            }

            /// What it is.
            #[must_use]
            pub fn meaning(self) -> &'static str {
                match self {
                    $(Self::$name => $meaning,)*
                }
            }
        }
    };
}

observables! {
    Last, called "final": "The last point.";
    Drift, called "drift": "The drift of the claimed integrals, relative to their first values.";
    Extrema, called "extrema": "The least and the greatest value of each variable.";
    Lyapunov, called "lyapunov": "The largest Lyapunov exponent, per unit of time.";
    Spectrum, called "spectrum": "All Lyapunov exponents, per unit of time.";
    LogDet, called "log_det": "The mean of log |det ∂x̃/∂x|, the sum of all exponents.";
    Fli, called "fli": "The fast Lyapunov indicator.";
    Megno, called "megno": "The mean of MEGNO.";
    Sali, called "sali": "The smaller alignment index.";
    Rotation, called "rotation": "Turns a step of each variable about the middle of its extremes.";
    Escape, called "escape": "The step after which a variable is beyond a size.";
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
    /// All exponents, the largest first.
    Spectrum(Vec<Exponent>),
    /// An indicator.
    Number(f64),
    /// Turns a step of each variable.
    Turns(Vec<Turns>),
    /// The step of the escape.
    Step(Option<u64>),
}

impl Observable {
    /// The columns that hold it, of a field with these variables and integrals.
    pub(in crate::question) fn columns(self, variables: &[String], integrals: &[String]) -> Vec<Column> {
        let one =
            |name: &str, meaning: &str| vec![Column { name: name.to_owned(), meaning: meaning.to_owned() }];
        let each = |names: &[String], parts: &[(&str, &str, &str)]| {
            let of = |name: &String| {
                let column = |(before, after, meaning): &(&str, &str, &str)| Column {
                    name: format!("{before}{name}{after}"),
                    meaning: (*meaning).to_owned(),
                };
                parts.iter().map(column).collect::<Vec<_>>()
            };
            names.iter().flat_map(of).collect()
        };
        match self {
            Self::Last => each(variables, &[("final_", "", "value after the last step")]),
            Self::Drift => each(
                integrals,
                &[
                    ("drift_", "", "largest change of the integral, relative to its first value"),
                    (
                        "drift_",
                        "_final",
                        "change of the integral after the last step, relative to its first value",
                    ),
                ],
            ),
            Self::Extrema => {
                each(variables, &[("least_", "", "least value"), ("greatest_", "", "greatest value")])
            }
            Self::Lyapunov => [
                one("lyapunov", "largest Lyapunov exponent, per unit of time"),
                one("lyapunov_error", "how far the exponent has converged, per unit of time"),
            ]
            .concat(),
            Self::Spectrum => {
                let of = |k: usize| one(&format!("lyapunov_{k}"), "Lyapunov exponent, per unit of time");
                (1..=variables.len()).flat_map(of).collect()
            }
            Self::LogDet => one("mean_log_det", "sum of all Lyapunov exponents, per unit of time"),
            Self::Fli => one("fli", "fast Lyapunov indicator"),
            Self::Megno => one("megno", "mean exponential growth factor of nearby orbits"),
            Self::Sali => one("sali", "smaller alignment index"),
            Self::Rotation => each(
                variables,
                &[
                    ("rotation_", "", "turns a step, modulo 1"),
                    ("rotation_", "_error", "turns a step that may be wrong"),
                ],
            ),
            Self::Escape => {
                one("escaped", "step after which a variable is beyond `escape`; not a number where none is")
            }
        }
    }
}

impl Seen {
    /// The numbers of the columns, in their order; what there is none of is not a number.
    pub(in crate::question) fn numbers(&self) -> Vec<f64> {
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
        }
    }
}
