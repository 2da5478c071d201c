//! Writes the values in an answer to [`Trade`](super::Trade) as JSON.

use kahan_algebra::rational::Rational;
use kahan_dynamics::{Need, Scene, Scheme, Setting};
use serde::{Deserialize, Serialize, Serializer};

use crate::named::{Names, by_name};
use crate::numbers::exact::ExactJson;

#[derive(Serialize, Deserialize)]
#[serde(remote = "Need", rename_all = "lowercase")]
pub(super) enum NeedByName {
    Trajectory,
    Integrals,
}

/// Returns a scene's requirement as users write it in questions: `trajectory` or `integrals`.
#[must_use]
pub fn need_name(need: Need) -> &'static str {
    match need {
        Need::Trajectory => "trajectory",
        Need::Integrals => "integrals",
    }
}

#[derive(Serialize)]
struct SchemeByName {
    scalar: &'static str,
    order: u32,
    compensated: bool,
}

impl SchemeByName {
    fn of(scheme: Scheme) -> Self {
        Self { scalar: scheme.precision.name(), order: scheme.order(), compensated: scheme.compensated }
    }
}

pub(super) fn parameters<S: Serializer>(values: &Names<Rational>, to: S) -> Result<S::Ok, S::Error> {
    by_name(&values.iter().map(|(name, value)| (name.clone(), value.to_json())).collect(), to)
}

pub(super) fn scene<S: Serializer>(scene: &Scene, to: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Shown {
        horizon: f64,
        need: &'static str,
        tolerance: f64,
    }
    let (horizon, tolerance) = (scene.horizon(), scene.tolerance());
    Shown { horizon, need: need_name(scene.need()), tolerance }.serialize(to)
}

pub(super) fn timing<S: Serializer>(is_code: &bool, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(if *is_code { "measured" } else { "predicted" })
}

pub(super) fn setting<S: Serializer>(setting: &Setting, to: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Shown {
        #[serde(flatten)]
        scheme: SchemeByName,
        eps: f64,
        steps: u64,
    }
    let scheme = SchemeByName::of(setting.scheme());
    Shown { scheme, eps: setting.eps(), steps: setting.steps() }.serialize(to)
}

pub(super) fn skipped<S: Serializer>(skipped: &[(Scheme, f64)], to: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Shown {
        #[serde(flatten)]
        scheme: SchemeByName,
        eps: f64,
    }
    to.collect_seq(skipped.iter().map(|&(scheme, eps)| Shown { scheme: SchemeByName::of(scheme), eps }))
}
