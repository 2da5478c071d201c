//! The Diophantine integrability test on one exact orbit.

use kahan_algebra::rational::Rational;
use kahan_discover::{Progress, Unwatched, Watch};
use kahan_runtime::heights::{DiophantineTest, HeightsOrbit, Stop};
use serde::ser::SerializeMap;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Map, Value};

use crate::error::StudyError;
use crate::numbers::exact;
use crate::rows::{Column, StoredColumn};
use crate::study::{NoStep, Study};

use super::over::{AtCell, CellEntry, column};
use super::{minute, seconds_since};

/// A request for the growth of numerators and denominators along an exact orbit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Heights {
    /// ε, half the time step.
    #[serde(with = "exact")]
    pub eps: Rational,
    /// The first point, with a coordinate for each variable.
    #[serde(with = "exact")]
    pub at: Vec<Rational>,
    /// The number of steps.
    pub steps: u64,
    /// The largest number of decimal digits that a numerator or denominator may have.
    #[serde(default = "usual_digits")]
    pub digits: u64,
    /// The time limit in seconds; a step that would probably exceed it is not begun.
    #[serde(default = "minute")]
    pub seconds: f64,
}

fn usual_digits() -> u64 {
    1_000_000
}

/// The answer to [`Heights`].
#[derive(Clone, Debug)]
pub struct HeightsFound {
    /// The name of the system.
    pub system: String,
    /// The state variables.
    pub variables: Vec<String>,
    /// The heights, their growth, and the reason why the orbit ended.
    pub survey: DiophantineTest,
    /// The duration of the computation in seconds; `None` without a clock.
    pub seconds: Option<f64>,
    /// The pole that ended the orbit.
    pub pole: Option<NoStep>,
}

impl Heights {
    /// Asks for an orbit that ends, at the latest, at a million digits or after a minute.
    #[must_use]
    pub fn new(eps: Rational, at: Vec<Rational>, steps: u64) -> Self {
        Heights { eps, at, steps, digits: usual_digits(), seconds: minute() }
    }

    /// Follows the orbit of a system whose claims hold.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, missing values, or a field that is undefined at its
    /// parameters.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<HeightsFound, StudyError> {
        let begun = watch.now();
        let system = study.proved()?;
        let (start, parameters) = (study.point(&self.at)?, study.values()?);
        let orbit = HeightsOrbit::new(system, &parameters, &self.eps, &start);
        let mut orbit = orbit.map_err(|_| study.undefined_field_at(&self.eps))?.within_digits(self.digits);
        let clock = || Some(watch.now()?.saturating_sub(begun?));
        let survey = DiophantineTest::within(&mut orbit, self.steps, self.seconds, &clock, |heights| {
            watch.look(&Progress { what: "steps", done: heights.step as u64, of: Some(self.steps) })
        });
        Ok(HeightsFound {
            system: study.name().to_owned(),
            variables: study.variables().to_vec(),
            pole: (survey.stopped == Some(Stop::Pole)).then(|| study.pole()),
            survey,
            seconds: seconds_since(begun, watch),
        })
    }
}

impl AtCell for Heights {
    fn place(&self) -> (Option<&Rational>, Option<&[Rational]>) {
        (Some(&self.eps), Some(&self.at))
    }

    fn columns(&self, variables: &[String]) -> Vec<(Column, StoredColumn)> {
        let growth = [
            column("steps", "steps that were made", StoredColumn::Integer),
            column(
                "growth",
                "how heights grow: bounded, logarithmic, linear, quadratic, exponential or undecided",
                StoredColumn::Text,
            ),
            column(
                "entropy",
                "logarithm of the last quotient of heights where these grow exponentially",
                StoredColumn::F64,
            ),
        ];
        let meaning = "logarithmic height at the last step, natural logarithm";
        let last = |name: &String| column(&format!("height_{name}"), meaning, StoredColumn::F64);
        growth.into_iter().chain(variables.iter().map(last)).collect()
    }

    fn entries(&self, eps: &Rational, at: &[Rational], study: &Study) -> Vec<CellEntry> {
        let asked = Heights { eps: eps.clone(), at: at.to_vec(), ..self.clone() };
        let none = |growth: &str| (0, growth.to_owned(), f64::NAN, vec![f64::NAN; study.variables().len()]);
        let (steps, growth, entropy, last) = match asked.ask(study, &Unwatched) {
            Ok(found) => match found.survey.heights.last() {
                Some(last) => {
                    let DiophantineTest { growth, entropy, .. } = &found.survey;
                    (found.steps(), growth.to_string(), *entropy, last.logarithms.clone())
                }
                None => none("undecided"),
            },
            Err(_) => none("undefined"),
        };
        let growth = [CellEntry::Integer(steps as i64), CellEntry::Text(growth), CellEntry::Float(entropy)];
        growth.into_iter().chain(last.into_iter().map(CellEntry::Float)).collect()
    }
}

impl HeightsFound {
    /// Returns the number of steps of the orbit.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.survey.heights.len().saturating_sub(1)
    }
}

/// Rounds log max(|p|, |q|), the height of a fraction p/q, to 15 significant digits.
#[must_use]
pub fn fifteen_digits(height: f64) -> f64 {
    format!("{height:.14e}").parse().expect("a printed float is one")
}

impl Serialize for HeightsFound {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let series = |i| -> Value {
            self.survey.component(i).into_iter().skip(1).map(fifteen_digits).map(Value::from).collect()
        };
        let series: Map<_, _> = self.variables.iter().cloned().zip((0..).map(series)).collect();
        let stopped = self.survey.stopped.map(|stop| match stop {
            Stop::Pole => "pole",
            Stop::Digits => "digits",
            Stop::Seconds => "seconds",
        });
        let mut object = serializer.serialize_map(None)?;
        object.serialize_entry("system", &self.system)?;
        object.serialize_entry("steps", &self.steps())?;
        object.serialize_entry("log_heights", &series)?;
        object.serialize_entry("growth", &self.survey.growth.to_string())?;
        object.serialize_entry("entropy", &self.survey.entropy)?;
        object.serialize_entry("seconds", &self.seconds)?;
        object.serialize_entry("stopped", &stopped)?;
        object.end()
    }
}
