//! What an orbit does: exponents, indicators of chaos, rotation, drift, escape.
//!
//! The orbit is followed twice: once for all that needs no extremes, once for the rotation about
//! their middle. Nothing of it is stored.

use std::cell::Cell;
use std::ops::ControlFlow;

use kahan_algebra::rational::Rational;
use kahan_algebra::syntax::ClaimKind;
use kahan_core::Composition;
use kahan_core::observe::{
    Drifted, Escape, Exponent, Extremes, Fli, MeanLogDet, Megno, Sali, Spectrum, Turns,
};
use kahan_discover::{Progress, Watch};
use kahan_runtime::{Ended, Follow, Followed, IntegralDrift};
use serde::{Deserialize, Serialize, Serializer};

use crate::error::StudyError;
use crate::named::{Names, by_name};
use crate::numbers::exact;
use crate::study::Study;

/// Asks what the orbit of a point does, in doubles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Observe {
    /// ε, half the time step.
    #[serde(with = "exact")]
    pub eps: Rational,
    /// The first point, a coordinate for each variable.
    #[serde(with = "exact::list")]
    pub at: Vec<Rational>,
    /// The number of steps.
    pub steps: u64,
    /// The order of the method: 2 is Kahan's map; 4, 6 and 8 compose steps of it.
    #[serde(default = "usual_order")]
    pub order: u32,
    /// Steps between two times that tangent vectors are made orthogonal.
    #[serde(default = "usual_every")]
    pub every: u64,
    /// The size of a variable beyond which the orbit has escaped.
    #[serde(default = "usual_escape")]
    pub escape: f64,
}

fn usual_order() -> u32 {
    2
}

fn usual_every() -> u64 {
    10
}

fn usual_escape() -> f64 {
    1e6
}

/// What was observed; exponents are per unit of time, of which a step takes 2ε.
#[derive(Clone, Debug)]
pub struct Observed {
    /// The name of the system.
    pub system: String,
    /// The state variables.
    pub variables: Vec<String>,
    /// The integrals that are claimed without `when`.
    pub integrals: Vec<String>,
    /// The steps that were made: fewer than asked where numbers leave their range, or the watch
    /// stopped the run.
    pub steps: u64,
    /// Whether numbers left the range of doubles.
    pub left_range: bool,
    /// Lyapunov exponents, the largest first, each with how far it has converged.
    pub lyapunov: Vec<Exponent>,
    /// The mean of log |det ∂x̃/∂x|, which is their sum.
    pub mean_log_det: f64,
    /// The fast Lyapunov indicator.
    pub fli: f64,
    /// The mean MEGNO.
    pub megno: f64,
    /// The smaller alignment index.
    pub sali: f64,
    /// Turns a step of each variable about the middle of its extremes.
    pub rotation: Vec<Turns>,
    /// How far each integral drifted, relative to its first value.
    pub drift: Vec<Drifted>,
    /// The extremes of each variable.
    pub extrema: Vec<Option<Extremes<f64>>>,
    /// The step of the escape.
    pub escaped: Option<u64>,
}

impl Observe {
    /// Kahan's map, tangent vectors made orthogonal every ten steps, escape beyond a million.
    #[must_use]
    pub fn new(eps: Rational, at: Vec<Rational>, steps: u64) -> Self {
        let (order, every, escape) = (usual_order(), usual_every(), usual_escape());
        Observe { eps, at, steps, order, every, escape }
    }

    /// Follows the orbit of a system whose claims hold. Costs two runs of the orbit, the first with
    /// as many tangent vectors as there are variables and some more.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing or beyond the range of
    /// doubles, an order that there is not, a field that is not defined at its parameters.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Observed, StudyError> {
        let system = study.proved()?;
        let (at, start) = study.in_floats(&self.at, &self.eps)?;
        if self.every == 0 {
            return Err(StudyError::NotPositive { what: "every", value: Rational::zero() });
        }
        let composition = Composition::of_order(self.order).ok_or(StudyError::Order(self.order))?;
        let at = at.composed(composition);
        let done = Cell::new(0);
        let tell = |steps| -> ControlFlow<()> {
            done.set(done.get() + steps);
            watch.look(&Progress { what: "steps", done: done.get(), of: Some(2 * self.steps) })
        };

        let tangents = (
            Spectrum::new(&at, start.len(), self.every),
            MeanLogDet::new(&at),
            Fli::new(&at),
            Megno::new(&at),
            Sali::new(&at),
        );
        let beyond = Escape::when(|x: &[f64]| !x.iter().all(|x| x.abs() <= self.escape));
        let observers = (tangents, beyond, at.extremes(), IntegralDrift::of(&at));
        let Followed { report, steps, ended } =
            at.observe(&mut start.clone(), self.steps, observers, tell).expect("the start is of the field");
        let ((lyapunov, mean_log_det, fli, megno, sali), escaped, extremes, drift) = report;
        let rotations = at.rotations(steps, &extremes);
        // Who stopped the first run wants no second one.
        let again = if ended == Ended::Stopped { 0 } else { steps };
        let again =
            at.observe(&mut start.clone(), again, rotations, tell).expect("the start is of the field");
        let [extrema, _] = extremes;
        let integrals = system.accessors(ClaimKind::Integral).map(|claim| claim.name.text.clone());
        Ok(Observed {
            system: study.name().to_owned(),
            variables: study.variables().to_vec(),
            integrals: integrals.collect(),
            steps,
            left_range: ended == Ended::Range,
            lyapunov,
            mean_log_det,
            fli,
            megno: megno.mean,
            sali,
            rotation: again.report,
            drift,
            extrema,
            escaped,
        })
    }
}

#[derive(Serialize)]
struct Object<'a> {
    system: &'a str,
    steps: u64,
    lyapunov: Vec<f64>,
    lyapunov_errors: Vec<f64>,
    mean_log_det: f64,
    fli: f64,
    megno: f64,
    sali: f64,
    #[serde(serialize_with = "by_name")]
    rotation: Names<Rotation>,
    #[serde(serialize_with = "by_name")]
    drift: Names<Drift>,
    #[serde(serialize_with = "by_name")]
    extrema: Names<Option<[f64; 2]>>,
    escaped: Option<u64>,
}

#[derive(Serialize)]
struct Rotation {
    value: f64,
    error: f64,
}

#[derive(Serialize)]
struct Drift {
    max: f64,
    #[serde(rename = "final")]
    last: f64,
}

impl Serialize for Observed {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        fn named<T>(names: &[String], values: impl Iterator<Item = T>) -> Names<T> {
            names.iter().cloned().zip(values).collect()
        }
        let rotation = self.rotation.iter().map(|turns| Rotation { value: turns.value, error: turns.error });
        let drift = self.drift.iter().map(|drifted| Drift { max: drifted.max, last: drifted.last });
        let extrema = self.extrema.iter().map(|extremes| extremes.map(|of| [of.least, of.greatest]));
        let object = Object {
            system: &self.system,
            steps: self.steps,
            lyapunov: self.lyapunov.iter().map(|exponent| exponent.value).collect(),
            lyapunov_errors: self.lyapunov.iter().map(|exponent| exponent.error).collect(),
            mean_log_det: self.mean_log_det,
            fli: self.fli,
            megno: self.megno,
            sali: self.sali,
            rotation: named(&self.variables, rotation),
            drift: named(&self.integrals, drift),
            extrema: named(&self.variables, extrema),
            escaped: self.escaped,
        };
        object.serialize(serializer)
    }
}
