//! What was measured as an object of JSON.

use kahan_algebra::rational::Rational;
use kahan_dynamics::{Need, Scheme};
use serde::{Deserialize, Serialize, Serializer};

use super::{Measured, Traded};
use crate::named::{Names, by_name};
use crate::reference::Method;

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

#[derive(Serialize)]
struct Object<'a> {
    system: &'a str,
    #[serde(serialize_with = "by_name")]
    parameters: Names<String>,
    x: Vec<String>,
    horizon: f64,
    need: &'static str,
    tolerance: f64,
    scale: Option<f64>,
    reference: Option<Agreement>,
    timing: &'static str,
    settings: &'a [Measured],
    choice: Option<Choice<'a>>,
    skipped: Vec<Skipped>,
}

#[derive(Serialize)]
struct Agreement {
    second_method: &'static str,
    difference: f64,
}

#[derive(Serialize)]
struct Choice<'a> {
    #[serde(flatten)]
    setting: &'a Measured,
    rust: &'a str,
}

#[derive(Serialize)]
struct Skipped {
    #[serde(flatten)]
    scheme: Named,
    eps: f64,
}

#[derive(Serialize)]
struct Named {
    scalar: &'static str,
    order: u32,
    compensated: bool,
}

#[derive(Serialize)]
struct Setting {
    #[serde(flatten)]
    scheme: Named,
    eps: f64,
    steps: u64,
    nanoseconds_per_unit_time: f64,
    trajectory_error: Option<f64>,
    integral_drift: Option<f64>,
    flow_integral_drift: Option<f64>,
    return_error: Option<f64>,
    on_front: bool,
}

impl Named {
    fn of(scheme: Scheme) -> Self {
        Named { scalar: scheme.precision.name(), order: scheme.order(), compensated: scheme.compensated }
    }
}

impl Serialize for Measured {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let setting = Setting {
            scheme: Named::of(self.setting.scheme()),
            eps: self.setting.eps(),
            steps: self.setting.steps(),
            nanoseconds_per_unit_time: self.nanoseconds_per_unit_time,
            trajectory_error: self.trajectory_error,
            integral_drift: self.integral_drift,
            flow_integral_drift: self.flow_integral_drift,
            return_error: self.return_error,
            on_front: self.on_front,
        };
        setting.serialize(serializer)
    }
}

impl Serialize for Traded {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let texts = |values: &[Rational]| values.iter().map(ToString::to_string).collect();
        let parameters = self.parameters.iter().map(|(name, value)| (name.clone(), value.to_string()));
        let choice = self.choice().zip(self.rust.as_deref());
        let object = Object {
            system: &self.system,
            parameters: parameters.collect(),
            x: texts(&self.start),
            horizon: self.scene.horizon(),
            need: need_name(self.scene.need()),
            tolerance: self.scene.tolerance(),
            scale: self.scale,
            reference: self.certificate.map(|certificate| Agreement {
                second_method: match certificate.method {
                    Method::ClosedSolution => "closed solution",
                    Method::Composition { .. } => "composition",
                },
                difference: certificate.difference,
            }),
            timing: if self.is_code { "measured" } else { "predicted" },
            settings: &self.settings,
            choice: choice.map(|(setting, rust)| Choice { setting, rust }),
            skipped: self
                .skipped
                .iter()
                .map(|&(scheme, eps)| Skipped { scheme: Named::of(scheme), eps })
                .collect(),
        };
        object.serialize(serializer)
    }
}
