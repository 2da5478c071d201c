//! Questions and their answers, as values.
//!
//! A question says what is asked, not of which field: that is the [`Subject`](crate::Subject)'s. It
//! reads itself from JSON, where `ask` names it: `{"ask": "evaluate", "eps": "1/2", "at": [1, 2,
//! 3]}`; a name that it does not have is a mistake.

mod discover;
mod evaluate;
mod heights;
mod observe;
mod periodic;
mod poles;
mod scan;

use std::time::Duration;

use kahan_discover::Watch;
use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};

use crate::error::StudyError;
use crate::study::Study;
use crate::trade::{Trade, Traded};

pub use discover::{Discover, Discovered};
pub use evaluate::{Evaluate, Evaluated, NoStep};
pub use heights::{Heights, HeightsFound, fifteen_digits};
pub use observe::{Observe, Observed};
pub use periodic::{CycleFound, Periodic, characteristic_polynomial};
pub use poles::{Poles, PolesFound};
pub use scan::{Scan, ScanFound};

/// What is asked.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "ask", rename_all = "lowercase")]
pub enum Question {
    /// Every object at a point.
    Evaluate(Evaluate),
    /// What an orbit does.
    Observe(Observe),
    /// A cycle and its branch.
    Periodic(Periodic),
    /// The heights of an exact orbit.
    Heights(Heights),
    /// What becomes of singularities.
    Poles(Poles),
    /// What the map preserves.
    Discover(Discover),
    /// Special values of parameters and of ε.
    Scan(Scan),
    /// Speed against accuracy on a scene.
    Trade(Trade),
}

/// The answer to a question, which has its names in JSON.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Answer {
    /// Every object at a point.
    Evaluate(Evaluated),
    /// What an orbit does.
    Observe(Observed),
    /// A cycle and its branch.
    Periodic(CycleFound),
    /// The heights of an exact orbit.
    Heights(HeightsFound),
    /// What becomes of singularities.
    Poles(PolesFound),
    /// What the map preserves.
    Discover(Box<Discovered>),
    /// Special values of parameters and of ε.
    Scan(ScanFound),
    /// Speed against accuracy on a scene.
    Trade(Traded),
}

/// The values of `ask`.
const NAMES: [&str; 8] = ["evaluate", "observe", "periodic", "heights", "poles", "discover", "scan", "trade"];

/// The seconds since then; `None` without a clock.
fn seconds_since(begun: Option<Duration>, watch: &dyn Watch) -> Option<f64> {
    Some(watch.now()?.saturating_sub(begun?).as_secs_f64())
}

impl Question {
    pub(crate) fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Answer, StudyError> {
        match self {
            Self::Evaluate(asked) => asked.ask(study).map(Answer::Evaluate),
            Self::Observe(asked) => asked.ask(study, watch).map(Answer::Observe),
            Self::Periodic(asked) => asked.ask(study, watch).map(Answer::Periodic),
            Self::Heights(asked) => asked.ask(study, watch).map(Answer::Heights),
            Self::Poles(asked) => asked.ask(study, watch).map(Answer::Poles),
            Self::Discover(asked) => Ok(Answer::Discover(Box::new(asked.ask(study, watch)?))),
            Self::Scan(asked) => asked.ask(study, watch).map(Answer::Scan),
            Self::Trade(asked) => asked.ask(study, watch).map(Answer::Trade),
        }
    }
}

/// The tag chooses the type, whose own reader then sees the rest: through serde's tagged enums exact
/// numbers of JSON do not come.
impl<'de> Deserialize<'de> for Question {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        fn rest<T: DeserializeOwned, E: Error>(rest: Map<String, Value>) -> Result<T, E> {
            serde_json::from_value(Value::Object(rest)).map_err(E::custom)
        }
        let mut object = Map::deserialize(deserializer)?;
        match object.remove("ask").as_ref().and_then(Value::as_str) {
            Some("evaluate") => rest(object).map(Self::Evaluate),
            Some("observe") => rest(object).map(Self::Observe),
            Some("periodic") => rest(object).map(Self::Periodic),
            Some("heights") => rest(object).map(Self::Heights),
            Some("poles") => rest(object).map(Self::Poles),
            Some("discover") => rest(object).map(Self::Discover),
            Some("scan") => rest(object).map(Self::Scan),
            Some("trade") => rest(object).map(Self::Trade),
            Some(other) => Err(D::Error::unknown_variant(other, &NAMES)),
            None => Err(D::Error::missing_field("ask")),
        }
    }
}
