//! Searches a grid for special values of parameters and of ε.

use kahan_algebra::rational::Rational;
use kahan_discover::scan::{DegreesAndRanks, GridPoint, Proposal};
use kahan_discover::{Scan as Grid, ScannedQuantity, Watch, scan};
use serde::ser::SerializeMap;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Map, Value, json};

use crate::axes;
use crate::error::StudyError;
use crate::numbers::exact::{self, ExactJson};
use crate::range::Axis;
use crate::study::Study;

use super::discover::options;
use super::{minute, seconds_since};

const MOST_POINTS: usize = 1_000_000;

/// A request to search a grid of parameter values and ε for special maps, and for relations between
/// the special values. A map is special if its iterates do not have the generic degrees, or its
/// orbits not the generic Hilbert function.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scan {
    /// ε, half the time step, if fixed; otherwise ε is generic.
    #[serde(with = "exact", default)]
    pub eps: Option<Rational>,
    /// The axes: parameters, or `eps`.
    #[serde(with = "axes")]
    pub over: Vec<Axis>,
    /// The largest degree of the sought polynomials that vanish on orbits.
    #[serde(default)]
    pub degree: Option<u32>,
    /// The time limit in seconds.
    #[serde(default = "minute")]
    pub seconds: f64,
}

/// The findings on a grid.
#[derive(Clone, Debug, Serialize)]
pub struct ScanFound {
    /// The name of the system.
    pub system: String,
    /// The results at the grid points that were searched, and the relations between special points.
    #[serde(flatten, serialize_with = "grid")]
    pub found: Grid,
    /// The number of points of the whole grid.
    #[serde(skip)]
    pub total: usize,
    /// The duration of the search in seconds; `None` without a clock.
    pub seconds: Option<f64>,
}

impl Scan {
    /// Asks for a search over these axes that lasts at most a minute.
    #[must_use]
    pub fn new(over: Vec<Axis>) -> Self {
        Scan { over, seconds: minute(), ..Scan::default() }
    }

    /// Returns the number of points of the grid; `None` above a million.
    #[must_use]
    pub fn points(&self) -> Option<usize> {
        let total = self.over.iter().try_fold(1usize, |count, axis| count.checked_mul(axis.range.count()));
        total.filter(|total| *total <= MOST_POINTS)
    }

    /// Searches every point. A parameter that has neither a value nor an axis is generic.
    ///
    /// # Errors
    /// [`StudyError`]: a missing or unknown axis, too many points, a degree that is too large,
    /// or a field for which no search is possible.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<ScanFound, StudyError> {
        let begun = watch.now();
        let options = options(study, &self.eps, self.degree, self.seconds)?;
        let axes = self.scanned(study)?;
        let total = self.points().ok_or(StudyError::ManyPoints { most: MOST_POINTS })?;
        let found = scan(study.system(), &axes, &options, watch);
        let found = found.map_err(|why| StudyError::Discover { system: study.name().to_owned(), why })?;
        Ok(ScanFound { system: study.name().to_owned(), found, total, seconds: seconds_since(begun, watch) })
    }

    /// Returns the axes, after checking that no axis also has a fixed value.
    fn scanned(&self, study: &Study) -> Result<Vec<ScannedQuantity>, StudyError> {
        if self.over.is_empty() {
            return Err(StudyError::NoAxis);
        }
        let fixed = study.fixed();
        let given = fixed.iter().map(|(name, _)| name.as_str()).chain(self.eps.as_ref().map(|_| "eps"));
        let mut taken: Vec<&str> = given.collect();
        for axis in &self.over {
            if axis.name != "eps" {
                study.parameter(&axis.name)?;
            }
            if taken.contains(&axis.name.as_str()) {
                return Err(StudyError::ParameterTwice { name: axis.name.clone() });
            }
            taken.push(&axis.name);
        }
        let scanned =
            |axis: &Axis| ScannedQuantity { name: axis.name.clone(), values: axis.range.values().collect() };
        Ok(self.over.iter().map(scanned).collect())
    }
}

fn grid<S: Serializer>(found: &Grid, serializer: S) -> Result<S::Ok, S::Error> {
    let seen = |sight: &DegreesAndRanks| {
        let DegreesAndRanks { integrals, hilbert, degrees } = sight;
        json!({"independent_integrals": integrals, "hilbert": hilbert, "degrees": degrees})
    };
    let values = |point: &GridPoint| -> Map<String, Value> {
        found.names.iter().cloned().zip(point.values.iter().map(ExactJson::to_json)).collect()
    };
    let point = |point: &GridPoint| json!({"values": values(point), "sight": point.sight.as_ref().map(seen)});
    let relation = |proposal: &Proposal| {
        let Proposal { relation, points, sight, claims } = proposal;
        json!({
            "relation": relation,
            "points": points,
            "sight": seen(sight),
            "claims": claims,
            "proved": !claims.is_empty(),
        })
    };
    let mut object = serializer.serialize_map(None)?;
    object.serialize_entry("names", &found.names)?;
    object.serialize_entry("generic", &seen(&found.generic))?;
    object.serialize_entry("points", &found.points.iter().map(point).collect::<Vec<_>>())?;
    object.serialize_entry("special", &found.special().map(values).collect::<Vec<_>>())?;
    object.serialize_entry("relations", &found.relations.iter().map(relation).collect::<Vec<_>>())?;
    object.serialize_entry("out_of_time", &found.out_of_time)?;
    object.end()
}
