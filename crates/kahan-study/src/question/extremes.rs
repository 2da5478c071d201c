//! How far floats can be trusted: steps at the extremes, judged by exact arithmetic.

use std::slice;

use kahan_discover::Watch;
use serde::{Deserialize, Serialize, Serializer};

use crate::error::StudyError;
use crate::extremes::{Broken, Cell, Count, Tally, Tried, survey, survey_odd, total, total_of_odd};
use crate::random_fields::{RandomField, numbered, odd};
use crate::study::Study;

use super::seconds_since;

/// Asks what steps make of points near poles, of mixed magnitudes, with subnormal and infinite
/// numbers. Parameters that are not given are drawn for each trial.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
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
#[derive(Clone, Debug)]
pub struct Judged {
    /// What was asked.
    pub asked: Extremes,
    /// The systems that shared the trials, each with whether it has removable poles.
    pub systems: Vec<(String, bool)>,
    /// The random fields among them.
    pub random_fields: Vec<RandomField>,
    /// A cell for each regime, tier and scalar, and what broke the promise.
    pub tally: Tally,
    /// The seconds that it took; `None` without a clock.
    pub seconds: Option<f64>,
}

impl Extremes {
    /// Tries the steps of one field. The claims of the field are not looked at.
    ///
    /// # Errors
    /// [`StudyError::Judge`].
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Judged, StudyError> {
        self.of(slice::from_ref(study), watch)
    }

    /// Tries the steps of several fields, of which there is at least one, in turn, on the watch's
    /// threads.
    ///
    /// # Errors
    /// [`StudyError::Judge`].
    pub fn of(&self, studies: &[Study], watch: &dyn Watch) -> Result<Judged, StudyError> {
        let begun = watch.now();
        let of_study = |study: &Study| {
            let name = study.name();
            Tried::new(name, study.system(), study.given().to_vec())
                .map_err(|why| StudyError::Judge { system: name.to_owned(), why })
        };
        let mut tried = studies.iter().map(of_study).collect::<Result<Vec<_>, _>>()?;
        let random_fields: Vec<RandomField> =
            (0..self.random_fields).map(|number| numbered(self.seed, number)).collect();
        tried.extend(random_fields.iter().map(|field| Tried::drawn(&field.name, field.block())));
        let count = Count::new(self.total(), watch);
        let mut tally = survey(&tried, self.trials, self.seed, &count);
        tally.add(survey_odd(self.odd_fields, self.odd_trials, self.seed, &count));
        Ok(Judged {
            asked: self.clone(),
            systems: tried
                .iter()
                .map(|tried| (tried.name().to_owned(), tried.has_removable_poles()))
                .collect(),
            random_fields,
            tally,
            seconds: seconds_since(begun, watch),
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

    /// The systems that broke the promise, with their equations where they were drawn.
    #[must_use]
    pub fn broken(&self) -> Vec<(&str, String, &Broken)> {
        let text = |name: &str| {
            let ordinary = self.random_fields.iter().find(|field| field.name == name);
            let mut odd = (0..self.asked.odd_fields).map(|number| odd(self.asked.seed, number));
            ordinary
                .map(RandomField::equations)
                .or_else(|| odd.find(|field| field.name == name).map(|field| field.equations))
                .unwrap_or_default()
        };
        self.tally.broken.iter().map(|(name, broken)| (name.as_str(), text(name), broken)).collect()
    }
}

#[derive(Serialize)]
struct Object<'a> {
    system: &'a str,
    systems: Vec<&'a str>,
    random_fields: Vec<(&'a str, String)>,
    odd_fields: usize,
    trials: u64,
    seed: u64,
    seconds: Option<f64>,
    cells: Vec<CellObject>,
    broken: Vec<BrokenObject<'a>>,
    failures: Vec<&'a str>,
}

#[derive(Serialize)]
struct CellObject {
    regime: &'static str,
    tier: &'static str,
    scalar: &'static str,
    trials: u64,
    max_error_u: Option<f64>,
    flagged: u64,
    unjustified_flags: u64,
    silently_wrong: u64,
}

#[derive(Serialize)]
struct BrokenObject<'a> {
    name: &'a str,
    text: String,
    silently_wrong: u64,
    unjustified_flags: u64,
    first: &'a str,
}

impl Serialize for Judged {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let systems: Vec<&str> = self.systems.iter().map(|(name, _)| name.as_str()).collect();
        let cells = self.tally.cells.iter().map(|(&(regime, tier, scalar), cell)| CellObject {
            regime: regime.name(),
            tier,
            scalar,
            trials: cell.trials,
            // JSON has no infinity.
            max_error_u: cell.max_error_u.map(|error| error.min(f64::MAX)),
            flagged: cell.flagged,
            unjustified_flags: cell.unjustified,
            silently_wrong: cell.silently_wrong,
        });
        let broken = self.broken().into_iter().map(|(name, text, broken)| BrokenObject {
            name,
            text,
            silently_wrong: broken.silently_wrong,
            unjustified_flags: broken.unjustified,
            first: &broken.first.text,
        });
        let object = Object {
            system: if let [system] = systems.as_slice() { system } else { "catalog" },
            random_fields: self
                .random_fields
                .iter()
                .map(|field| (field.name.as_str(), field.equations()))
                .collect(),
            odd_fields: self.asked.odd_fields,
            trials: self.asked.trials,
            seed: self.asked.seed,
            seconds: self.seconds,
            cells: cells.collect(),
            broken: broken.collect(),
            failures: self.tally.failures.iter().map(|failure| failure.text.as_str()).collect(),
            systems,
        };
        object.serialize(serializer)
    }
}
