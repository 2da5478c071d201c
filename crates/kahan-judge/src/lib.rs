//! Tests single steps by exact arithmetic, also near poles and near the limits of float formats.
//!
//! [`Extremes`] contains the settings. [`Judged`] contains, for each method such as `try_step`, the
//! largest error, the number of failures that the method reported, and the number of wrong results
//! that it did not report. A trial depends on the settings, the systems and its index, not on
//! threads.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod ball;
mod dyadic;
mod elimination;
mod equation;
mod float;
mod judge;
mod points;
mod polynomial;
pub mod random_fields;
mod regime;
mod roots;
mod steps;
mod survey;
mod tally;
#[cfg(test)]
mod tests;
mod trial;

use std::fmt;

use kahan_study::trade::CannotRun;
use kahan_study::{Study, Subject, Watch, WorkCount};
use kahan_systems::{registry, volterra};
use serde::Serialize;

use random_fields::odd::odd;
use random_fields::{RandomField, numbered};
use survey::{TestedMap, survey, survey_odd, total, total_of_odd};

pub use regime::Regime;
pub use tally::{BrokenPromises, Cell, CellKey, Failure, Tally};

/// Returns the systems in `registry::SYSTEMS`, and the Volterra lattice of three sites.
pub fn usual_subjects() -> impl Iterator<Item = Subject> {
    let entries = registry::SYSTEMS.iter().chain([&volterra::ENTRY]);
    entries.map(|entry| Subject::named(entry.command))
}

/// The settings of a survey, which tests steps at random points. Parameters without a given value
/// are drawn for each trial.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extremes {
    /// The number of trials for each scalar type. Trials with large steps, or with subnormal,
    /// infinite or NaN inputs, come in addition.
    pub trials: u64,
    /// The number of random fields. The trials are divided among them and the systems.
    pub random_fields: usize,
    /// The number of additional random fields with extreme coefficients.
    pub odd_fields: usize,
    /// The number of trials for each scalar type and each field with extreme coefficients. Every
    /// twentieth field has ten times this number.
    pub odd_trials: u64,
    /// The seed of points and fields. Equal seeds draw equal trials on any number of threads.
    pub seed: u64,
}

impl Default for Extremes {
    fn default() -> Self {
        Extremes { trials: 40_000, random_fields: 0, odd_fields: 0, odd_trials: 300, seed: 1 }
    }
}

/// The result of a survey.
#[derive(Clone, Debug, Serialize)]
pub struct Judged {
    /// The name of the system, or `catalog` for several systems.
    pub system: String,
    /// The systems among which the trials were divided.
    pub systems: Vec<String>,
    /// The name and the equations of each random field that got a part of the trials.
    pub random_fields: Vec<(String, String)>,
    /// The number of additional fields with extreme coefficients.
    pub odd_fields: usize,
    /// The number of trials for each scalar type, as in [`Extremes::trials`].
    pub trials: u64,
    /// The seed of points and fields.
    pub seed: u64,
    /// The duration of the survey in seconds; `None` on platforms without a clock.
    pub seconds: Option<f64>,
    /// The counts for each regime, kind of step and scalar type.
    #[serde(flatten)]
    pub tally: Tally,
    /// The names of the systems that have removable poles: zeros of det A that cancel in the map.
    #[serde(skip)]
    pub removable: Vec<String>,
}

impl Extremes {
    /// Tests steps of the given fields and of the random fields, on as many threads as `watch`
    /// allows.
    ///
    /// At least one field is needed.
    ///
    /// # Errors
    /// Returns [`CannotJudge`] if a field has too many variables or is undefined at its parameters.
    pub fn of(&self, studies: &[Study], watch: &dyn Watch) -> Result<Judged, CannotJudge> {
        let begun = watch.now();
        let of_study = |study: &Study| {
            let name = study.name();
            TestedMap::new(name, study.system(), study.given().to_vec())
                .map_err(|why| CannotJudge { system: name.to_owned(), why })
        };
        let mut tried = studies.iter().map(of_study).collect::<Result<Vec<_>, _>>()?;
        let fields: Vec<RandomField> =
            (0..self.random_fields).map(|number| numbered(self.seed, number)).collect();
        tried.extend(fields.iter().map(|field| TestedMap::drawn(&field.name, field.block())));
        let random_fields: Vec<(String, String)> =
            fields.iter().map(|field| (field.name.clone(), field.equations())).collect();
        let count = WorkCount::new("trials", self.total(), watch);
        let mut tally = survey(&tried, self.trials, self.seed, &count);
        tally.add(survey_odd(self.odd_fields, self.odd_trials, self.seed, &count));
        for (name, broken) in &mut tally.broken {
            let odd = (0..self.odd_fields).map(|number| odd(self.seed, number));
            let odd = odd.map(|field| (field.name, field.equations));
            let drawn = random_fields.iter().cloned().chain(odd).find(|(drawn, _)| drawn == name);
            broken.text = drawn.map(|(_, text)| text).unwrap_or_default();
        }
        let names = |is_meant: fn(&TestedMap) -> bool| {
            tried.iter().filter(|one| is_meant(one)).map(|one| one.target.name.clone()).collect::<Vec<_>>()
        };
        let systems = names(|_| true);
        Ok(Judged {
            system: if let [one] = &systems[..] { one.clone() } else { "catalog".to_owned() },
            systems,
            random_fields,
            odd_fields: self.odd_fields,
            trials: self.trials,
            seed: self.seed,
            seconds: watch.now().zip(begun).map(|(now, begun)| now.saturating_sub(begun).as_secs_f64()),
            tally,
            removable: names(|one| one.target.judge.has_removable_poles()),
        })
    }

    /// Returns the number of all trials.
    #[must_use]
    pub fn total(&self) -> u64 {
        total(self.trials) + total_of_odd(self.odd_fields, self.odd_trials)
    }
}

impl Judged {
    /// Counts the wrong results of `try_step`, and the well-conditioned steps that it refused. Both
    /// counts should be 0.
    #[must_use]
    pub fn against_the_promise(&self) -> [u64; 2] {
        let count = |of: fn(&Cell) -> u64| {
            let stable = self.tally.cells.iter().filter(|((_, tier, _), _)| *tier == "stable");
            stable.map(|(_, cell)| of(cell)).sum()
        };
        [count(|cell| cell.silently_wrong), count(|cell| cell.unjustified)]
    }
}

/// The reason why the steps of a field cannot be tested.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CannotJudge {
    /// The name of the field.
    pub system: String,
    /// The reason for the failure.
    pub why: CannotRun,
}

impl fmt::Display for CannotJudge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} cannot be judged: {}", self.system, self.why)
    }
}

impl std::error::Error for CannotJudge {}
