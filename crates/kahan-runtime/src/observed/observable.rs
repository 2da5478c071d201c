//! What can be observed of an orbit, by name, with the columns of a table that hold it.
//!
//! In: names. Out: names, columns, and what was seen as numbers of these columns. Which observer
//! finds what, its neighbour `running` knows.

use kahan_core::observe::{Drifted, Exponent, Extremes, Turns};

use crate::Passed;

macro_rules! observables {
    ($($name:ident, called $text:literal, $meaning:literal, $of:ident: $($column:literal = $what:literal),*;)*) => {
        /// What can be observed of an orbit.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Observable {
            $(#[doc = $meaning] $name,)*
        }

        impl Observable {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// Their names, in the same order.
            pub const NAMES: &'static [&'static str] = &[$($text),*];

            /// Its name in questions.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$name => $text,)*
                }
            }

            /// What it is, as a sentence.
            #[must_use]
            pub fn meaning(self) -> &'static str {
                match self {
                    $(Self::$name => $meaning,)*
                }
            }

            /// Of what it has columns, and these, with their meanings.
            fn written(self) -> (Of, &'static [(&'static str, &'static str)]) {
                match self {
                    $(Self::$name => (Of::$of, &[$(($column, $what)),*]),)*
                }
            }
        }
    };
}

/// Of what an observable has columns.
enum Of {
    Orbit,
    Variables,
    Integrals,
    /// The numbers from 1 up to that of the variables.
    Numbers,
}

observables! {
    Last, called "final", "The last point.", Variables: "final_{}" = "value after the last step";
    Drift, called "drift", "The drift of the claimed integrals, relative to their first values.", Integrals:
        "drift_{}" = "largest change of the integral, relative to its first value",
        "drift_{}_final" = "change of the integral after the last step, relative to its first value";
    Extrema, called "extrema", "The least and the greatest value of each variable.", Variables:
        "least_{}" = "least value", "greatest_{}" = "greatest value";
    Lyapunov, called "lyapunov", "The largest Lyapunov exponent, per unit of time.", Orbit:
        "lyapunov" = "largest Lyapunov exponent, per unit of time",
        "lyapunov_error" = "how far the exponent has converged, per unit of time";
    Spectrum, called "spectrum", "All Lyapunov exponents in descending order, per unit of time.", Numbers:
        "spectrum_{}" = "Lyapunov exponent, the largest first, per unit of time";
    LogDet, called "log_det", "The mean of log |det ∂x̃/∂x|, the sum of all exponents.", Orbit:
        "mean_log_det" = "sum of all Lyapunov exponents, per unit of time";
    Fli, called "fli", "The fast Lyapunov indicator.", Orbit: "fli" = "fast Lyapunov indicator";
    Megno, called "megno", "The mean of MEGNO.", Orbit:
        "megno" = "mean exponential growth factor of nearby orbits";
    Sali, called "sali", "The smaller alignment index.", Orbit: "sali" = "smaller alignment index";
    Rotation, called "rotation", "Turns a step of each variable about the middle of its extremes.", Variables:
        "rotation_{}" = "turns a step, modulo 1", "rotation_{}_error" = "turns a step that may be wrong";
    Escape, called "escape", "The step after which a variable is beyond a size.", Orbit:
        "escaped" = "step after which a variable is beyond `escape`; not a number where none is";
    PassedPoles, called "passed_poles", "The number of steps over a pole of the map.", Orbit:
        "passed_poles" = "steps over a pole: the reduced denominator has a root in (0, ε]",
        "passed_poles_lower_bound" = "1 where that is a lower bound, by the sign of det A, else 0";
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
    /// Whether it follows tangent vectors, which are those of the original variables where a field was
    /// lifted.
    #[must_use]
    pub fn is_of_tangent_vectors(self) -> bool {
        use Observable::{Fli, LogDet, Lyapunov, Megno, Sali, Spectrum};
        matches!(self, Lyapunov | Spectrum | LogDet | Fli | Megno | Sali)
    }

    /// The columns of a table that hold it, of a field with these variables and integrals: names
    /// and meanings.
    #[must_use]
    pub fn columns(self, variables: &[String], integrals: &[String]) -> Vec<(String, &'static str)> {
        let (of, columns) = self.written();
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
