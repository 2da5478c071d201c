//! How far floats can be trusted: steps at the extremes, judged by exact arithmetic.
//!
//! In: systems, a number of trials, a seed ([`Extremes`]). Out: for every regime, tier and scalar
//! how large the errors are, how many trials are flagged, and how many are silently wrong
//! ([`Judged`]). The judge knows the reduced map as polynomials and takes the floats as they are
//! given, so no tolerance is between a step and its verdict. What a trial draws depends on the seed
//! and its index only: the result is the same for every number of threads.
//!
//! This crate must not know terminals, files, flags or HTML; fronts ask and show.

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
use kahan_study::{Count, Study, Subject, Watch};
use kahan_systems::{registry, volterra};
use serde::Serialize;

use random_fields::odd::odd;
use random_fields::{RandomField, numbered};
use survey::{Tried, survey, survey_odd, total, total_of_odd};

pub use regime::Regime;
pub use tally::{Broken, Cell, Failure, Place, Tally};

/// The systems that are tried where no other is named: the paper's, and the lattice of three sites,
/// whose det A cancels in long steps.
pub fn usual_subjects() -> impl Iterator<Item = Subject> {
    let entries = registry::SYSTEMS.iter().chain([&volterra::ENTRY]);
    entries.map(|entry| Subject::named(entry.command))
}

/// Asks what steps make of points near poles, of mixed magnitudes, with subnormal and infinite
/// numbers. Parameters that are not given are drawn for each trial.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extremes {
    /// The number of trials of each scalar, besides three thirty-second parts with special inputs.
    pub trials: u64,
    /// Besides, so many random fields of two to six variables, which share the trials.
    pub random_fields: usize,
    /// Besides, so many random fields of odd tempers.
    pub odd_fields: usize,
    /// The number of trials of each scalar that each field of odd temper has; every twentieth field
    /// has ten times as many.
    pub odd_trials: u64,
    /// Another seed draws other points and fields; the same seed draws the same, on any number of
    /// threads.
    pub seed: u64,
}

/// Forty thousand trials, no random fields.
impl Default for Extremes {
    fn default() -> Self {
        Extremes { trials: 40_000, random_fields: 0, odd_fields: 0, odd_trials: 300, seed: 1 }
    }
}

/// What was tried, and what came of it.
#[derive(Clone, Debug, Serialize)]
pub struct Judged {
    /// The name of the system, or `catalog` where there are several.
    pub system: String,
    /// The systems that shared the trials.
    pub systems: Vec<String>,
    /// The random fields among them, with their equations.
    pub random_fields: Vec<(String, String)>,
    /// How many fields of odd tempers were tried besides.
    pub odd_fields: usize,
    /// The number of trials of each scalar.
    pub trials: u64,
    /// What drew points and fields.
    pub seed: u64,
    /// The seconds that it took; `None` without a clock.
    pub seconds: Option<f64>,
    /// A cell for each regime, tier and scalar, and what broke the promise.
    #[serde(flatten)]
    pub tally: Tally,
    /// The systems that have removable poles.
    #[serde(skip)]
    pub removable: Vec<String>,
}

impl Extremes {
    /// Tries the steps of some fields, of which there is at least one, in turn, on the watch's
    /// threads. The claims of the fields are not looked at.
    ///
    /// # Errors
    /// [`CannotJudge`] where a field has too many variables, or is not defined at its parameters.
    pub fn of(&self, studies: &[Study], watch: &dyn Watch) -> Result<Judged, CannotJudge> {
        let begun = watch.now();
        let of_study = |study: &Study| {
            let name = study.name();
            Tried::new(name, study.system(), study.given().to_vec())
                .map_err(|why| CannotJudge { system: name.to_owned(), why })
        };
        let mut tried = studies.iter().map(of_study).collect::<Result<Vec<_>, _>>()?;
        let fields: Vec<RandomField> =
            (0..self.random_fields).map(|number| numbered(self.seed, number)).collect();
        tried.extend(fields.iter().map(|field| Tried::drawn(&field.name, field.block())));
        let random_fields: Vec<(String, String)> =
            fields.iter().map(|field| (field.name.clone(), field.equations())).collect();
        let count = Count::new("trials", self.total(), watch);
        let mut tally = survey(&tried, self.trials, self.seed, &count);
        tally.add(survey_odd(self.odd_fields, self.odd_trials, self.seed, &count));
        for (name, broken) in &mut tally.broken {
            let odd = (0..self.odd_fields).map(|number| odd(self.seed, number));
            let odd = odd.map(|field| (field.name, field.equations));
            let drawn = random_fields.iter().cloned().chain(odd).find(|(drawn, _)| drawn == name);
            broken.text = drawn.map(|(_, text)| text).unwrap_or_default();
        }
        let names = |is_meant: fn(&Tried) -> bool| {
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

    /// How many trials there are in all.
    #[must_use]
    pub fn total(&self) -> u64 {
        total(self.trials) + total_of_odd(self.odd_fields, self.odd_trials)
    }
}

impl Judged {
    /// How often the stable tier was silently wrong, and how often it flagged without right: both 0
    /// where it keeps its promise.
    #[must_use]
    pub fn against_the_promise(&self) -> [u64; 2] {
        let count = |of: fn(&Cell) -> u64| {
            let stable = self.tally.cells.iter().filter(|((_, tier, _), _)| *tier == "stable");
            stable.map(|(_, cell)| of(cell)).sum()
        };
        [count(|cell| cell.silently_wrong), count(|cell| cell.unjustified)]
    }
}

/// Why the steps of a field cannot be tried.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CannotJudge {
    /// The field.
    pub system: String,
    /// Why.
    pub why: CannotRun,
}

impl fmt::Display for CannotJudge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} cannot be judged: {}", self.system, self.why)
    }
}

impl std::error::Error for CannotJudge {}
