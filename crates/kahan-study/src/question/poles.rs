//! The images of curves that a map contracts or sends to infinity (singularity confinement).

use kahan_algebra::rational::Rational;
use kahan_discover::orbits::growth::GrowthVerdict;
use kahan_discover::poles::{Image, Pattern};
use kahan_discover::{Watch, poles};
use serde::ser::SerializeMap;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::json;

use crate::error::StudyError;
use crate::numbers::exact;
use crate::study::Study;

use super::discover::options;
use super::seconds_since;

/// A request for the images of the curves, or surfaces, on which the map is singular.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Poles {
    /// ε, half the time step, if fixed; otherwise ε is generic.
    #[serde(with = "exact")]
    pub eps: Option<Rational>,
    /// The number of steps for which each curve is followed.
    pub steps: usize,
    /// The time limit in seconds; unfinished curves are undecided.
    pub seconds: f64,
}

impl Default for Poles {
    fn default() -> Self {
        Poles { eps: None, steps: 12, seconds: 60.0 }
    }
}

/// The singularity patterns of the curves.
#[derive(Clone, Debug, Serialize)]
pub struct PolesFound {
    /// The name of the system.
    pub system: String,
    /// The singularity patterns, and the degrees of iterates of the map.
    #[serde(flatten, serialize_with = "patterns")]
    pub found: kahan_discover::Poles,
    /// The growth of the degrees.
    #[serde(flatten, serialize_with = "class")]
    pub growth: GrowthVerdict,
    /// The duration of the search in seconds; `None` without a clock.
    pub seconds: Option<f64>,
}

impl Poles {
    /// Follows the curves modulo two primes. Parameters without values are generic. Ignores claims.
    ///
    /// # Errors
    /// [`StudyError::Discover`].
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<PolesFound, StudyError> {
        let begun = watch.now();
        let options = options(study, &self.eps, None, self.seconds)?;
        let found = poles(study.system(), &options, self.steps, watch);
        let found = found.map_err(|why| StudyError::Discover { system: study.name().to_owned(), why })?;
        Ok(PolesFound {
            system: study.name().to_owned(),
            growth: GrowthVerdict::of(&found.degrees),
            found,
            seconds: seconds_since(begun, watch),
        })
    }
}

fn patterns<S: Serializer>(found: &kahan_discover::Poles, serializer: S) -> Result<S::Ok, S::Error> {
    let image = |image: &Image| json!({"dimension": image.dimension, "infinite": image.is_infinite});
    let curve = |pattern: &Pattern| {
        json!({
            "curve": pattern.name(&found.symbols),
            "steps": pattern.steps,
            "confined": pattern.confined,
            "blown_down": pattern.is_blown_down(),
            "images": pattern.images.iter().take(pattern.steps).map(image).collect::<Vec<_>>(),
        })
    };
    let mut object = serializer.serialize_map(None)?;
    object.serialize_entry("patterns", &found.patterns.iter().map(curve).collect::<Vec<_>>())?;
    object.serialize_entry("bound", &found.bound)?;
    object.serialize_entry("complete", &found.is_complete)?;
    object.serialize_entry("degrees", &found.degrees)?;
    object.serialize_entry("implied_degrees", &found.implied_degrees)?;
    object.end()
}

fn class<S: Serializer>(verdict: &GrowthVerdict, serializer: S) -> Result<S::Ok, S::Error> {
    let mut object = serializer.serialize_map(None)?;
    object.serialize_entry("growth", verdict.growth.word())?;
    object.serialize_entry("entropy", &verdict.growth.entropy())?;
    object.end()
}
