//! What was measured as an object of JSON.

use kahan_core::{Need, Scheme};
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Value, json};

use super::{Measured, Traded};
use crate::numbers::exact::Exactly;
use crate::reference::Method;

/// A need by its name.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Need", rename_all = "lowercase")]
pub(super) enum Named {
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

fn json_of(scheme: Scheme) -> Value {
    json!({
        "scalar": scheme.precision.name(),
        "order": scheme.order(),
        "compensated": scheme.compensated,
    })
}

impl Serialize for Measured {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = json_of(self.setting.scheme());
        object["eps"] = json!(self.setting.eps());
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
        let choice = self.choice().zip(self.rust.as_deref()).map(|(setting, rust)| {
            let mut choice = json!(setting);
            choice["rust"] = json!(rust);
            choice
        });
        let skipped = self.skipped.iter().map(|&(scheme, eps)| {
            let mut skipped = json_of(scheme);
            skipped["eps"] = json!(eps);
            skipped
        });
        let object = json!({
            "system": self.system,
            "parameters": parameters.collect::<Value>(),
            "x": self.start.to_json(),
            "horizon": self.scene.horizon(),
            "need": need_name(self.scene.need()),
            "tolerance": self.scene.tolerance(),
            "scale": self.scale,
            "reference": self.certificate.map(|certificate| json!({
                "second_method": match certificate.method {
                    Method::ClosedSolution => "closed solution",
                    Method::Composition { .. } => "composition",
                },
                "difference": certificate.difference,
            })),
            "timing": if self.is_code { "measured" } else { "predicted" },
            "settings": self.settings,
            "choice": choice,
            "skipped": skipped.collect::<Value>(),
        });
        object.serialize(serializer)
    }
}
