//! What was measured as an object of JSON.

use kahan_dynamics::{Need, Scheme};
use serde::ser::SerializeMap;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Map, Value, json};

use super::{Measured, Traded};
use crate::numbers::exact::Exactly;
use crate::reference::{Certificate, Method};

/// A need by its name.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Need", rename_all = "lowercase")]
pub(super) enum NeedByName {
    Trajectory,
    Integrals,
}

/// The name of a need in questions and answers.
#[must_use]
pub fn need_name(need: Need) -> &'static str {
    match need {
        Need::Trajectory => "trajectory",
        Need::Integrals => "integrals",
    }
}

/// A scheme at an ε as an object of JSON.
fn object_of(scheme: Scheme, eps: f64) -> Value {
    json!({
        "scalar": scheme.precision.name(),
        "order": scheme.order(),
        "compensated": scheme.compensated,
        "eps": eps,
    })
}

impl Serialize for Measured {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = object_of(self.setting.scheme(), self.setting.eps());
        object["steps"] = json!(self.setting.steps());
        object["nanoseconds_per_unit_time"] = json!(self.nanoseconds_per_unit_time);
        object["trajectory_error"] = json!(self.trajectory_error);
        object["integral_drift"] = json!(self.integral_drift);
        object["flow_integral_drift"] = json!(self.flow_integral_drift);
        object["return_error"] = json!(self.return_error);
        object["on_front"] = json!(self.on_front);
        object.serialize(serializer)
    }
}

impl Serialize for Traded {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let parameters = self.parameters.iter().map(|(name, value)| (name.clone(), value.to_json()));
        let reference = |certificate: Certificate| {
            let second_method = match certificate.method {
                Method::ClosedSolution => "closed solution",
                Method::Composition { .. } => "composition",
            };
            json!({"second_method": second_method, "difference": certificate.difference})
        };
        let choice = |(setting, rust)| {
            let mut choice = json!(setting);
            choice["rust"] = json!(rust);
            choice
        };
        let mut object = serializer.serialize_map(None)?;
        object.serialize_entry("system", &self.system)?;
        object.serialize_entry("parameters", &parameters.collect::<Map<_, _>>())?;
        object.serialize_entry("x", &self.start.to_json())?;
        object.serialize_entry("horizon", &self.scene.horizon())?;
        object.serialize_entry("need", need_name(self.scene.need()))?;
        object.serialize_entry("tolerance", &self.scene.tolerance())?;
        object.serialize_entry("scale", &self.scale)?;
        object.serialize_entry("reference", &self.certificate.map(reference))?;
        object.serialize_entry("timing", if self.is_code { "measured" } else { "predicted" })?;
        object.serialize_entry("settings", &self.settings)?;
        object.serialize_entry("choice", &self.choice().zip(self.rust.as_ref()).map(choice))?;
        let skipped = self.skipped.iter().map(|&(scheme, eps)| object_of(scheme, eps));
        object.serialize_entry("skipped", &skipped.collect::<Vec<_>>())?;
        object.end()
    }
}
