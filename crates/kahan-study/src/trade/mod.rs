//! Compares settings of the integrator (scalar, order, compensation, ε) by error and cost.
//!
//! The library's own orbits are run and timed. Errors are distances from a [`Reference`] on which
//! two methods agree, or drifts of integrals.

mod drift;
mod front;
mod measure;
mod object;
mod prices;
mod runner;
mod rust_code;
mod search;
mod stops;

use std::ops::ControlFlow;
use std::time::Duration;

use kahan_algebra::rational::Rational;
use kahan_core::Dd;
use kahan_core::num_rational::BigRational;
use kahan_discover::{Progress, Watch};
use kahan_dynamics::search::Search;
use kahan_dynamics::{Need, Scene, Scheme, Setting};
use serde::{Deserialize, Serialize};

use crate::error::{Spelling, StudyError, by_name};
pub use crate::map::CannotRun;
use crate::map::rate;
use crate::named::Names;
use crate::numbers::{DoubleDouble, Printable, exact};
use crate::reference::{
    Certificate, NoReference, PART_OF_TOLERANCE, Reference, Trajectory, TrajectoryLimits,
};
use crate::study::Study;

use drift::Integrals;
use measure::SettingMeasurements;
use prices::Prices;
use runner::Runner;
use search::{MEASURED, RefinementSearch};

pub use object::need_name;

/// A request for the cheapest integrator setting for one simulation. The price is computing time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Trade {
    /// The first point, with a coordinate for each variable.
    #[serde(with = "exact")]
    pub at: Vec<Rational>,
    /// The time to be simulated, positive.
    #[serde(with = "exact")]
    pub horizon: Rational,
    /// The purpose of the orbit: `trajectory` or `integrals`.
    #[serde(with = "object::NeedByName", default = "trajectory")]
    pub need: Need,
    /// The largest accepted error, positive.
    #[serde(with = "exact", default = "usual_tolerance")]
    pub tolerance: Rational,
    /// The time limit of the measurement in seconds.
    #[serde(default = "usual_seconds")]
    pub seconds: f64,
}

fn trajectory() -> Need {
    Need::Trajectory
}

fn usual_tolerance() -> Rational {
    Rational::new(1, 100_000_000)
}

fn usual_seconds() -> f64 {
    10.0
}

/// A setting with its measured price and errors.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Measured {
    /// The setting.
    #[serde(flatten, serialize_with = "object::setting")]
    pub setting: Setting,
    /// The price in nanoseconds for a unit of simulated time.
    pub nanoseconds_per_unit_time: f64,
    /// The error for [`Need::Trajectory`], possibly infinite; `None` for another purpose.
    pub trajectory_error: Option<f64>,
    /// The error for [`Need::Integrals`]; `None` if no integral is declared.
    pub integral_drift: Option<f64>,
    /// The drift of the flow's integrals; `None` if no integral is declared.
    pub flow_integral_drift: Option<f64>,
    /// The distance from the start after all steps forward and back, relative to the start. Only
    /// settings on the Pareto front are measured.
    pub return_error: Option<f64>,
    /// Whether no other setting is both cheaper and more accurate.
    pub on_front: bool,
}

/// The answer to [`Trade`].
#[derive(Clone, Debug, Serialize)]
pub struct Traded {
    /// The name of the system.
    pub system: String,
    /// The values of its parameters.
    #[serde(serialize_with = "object::parameters")]
    pub parameters: Names<Rational>,
    /// The first point.
    #[serde(rename = "x", with = "exact")]
    pub start: Vec<Rational>,
    /// The simulated time, the purpose of the orbit and the tolerance.
    #[serde(flatten, serialize_with = "object::scene")]
    pub scene: Scene,
    /// The size of the trajectory; its errors are relative to this size.
    pub scale: Option<f64>,
    /// The evidence that errors of trajectories can be trusted.
    #[serde(rename = "reference")]
    pub certificate: Option<Certificate>,
    /// Whether prices were measured with this system's compiled steps; if not, they are estimated.
    #[serde(rename = "timing", serialize_with = "object::timing")]
    pub is_code: bool,
    /// The settings, cheapest first.
    pub settings: Vec<Measured>,
    /// The cheapest setting whose error is within the tolerance.
    pub choice: Option<Choice>,
    /// Schemes (scalar, order, compensation) that ran out of time, each with its first skipped ε.
    #[serde(serialize_with = "object::skipped")]
    pub skipped: Vec<(Scheme, f64)>,
    /// Schemes whose errors stopped falling before they reached the tolerance.
    #[serde(skip)]
    pub stalled: Vec<Scheme>,
}

/// The chosen setting.
#[derive(Clone, Debug, Serialize)]
pub struct Choice {
    /// The setting.
    #[serde(flatten)]
    pub setting: Measured,
    /// Rust code of the setting's orbit.
    pub rust: String,
}

/// The reason why nothing was measured.
#[derive(Clone, Debug, PartialEq)]
pub enum CannotTrade {
    /// The system cannot be run.
    CannotRun(CannotRun),
    /// No reference trajectory was found.
    Reference(NoReference),
    /// Integrals are to be preserved, but no claimed integral depends on the state.
    NoIntegrals,
}

impl core::fmt::Display for CannotTrade {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        self.tell(f, by_name)
    }
}

impl CannotTrade {
    pub(crate) fn tell(&self, f: &mut core::fmt::Formatter<'_>, spelling: Spelling) -> core::fmt::Result {
        match self {
            Self::CannotRun(why) => core::fmt::Display::fmt(why, f),
            Self::Reference(why) => why.tell(f, spelling),
            Self::NoIntegrals => write!(
                f,
                "no integral is claimed without `when`, so there is none to keep; claim one in the field (`integral H = …;`), \
                 or ask for {}",
                spelling("need", "trajectory")
            ),
        }
    }
}

impl core::error::Error for CannotTrade {}

impl Measured {
    /// Returns the error of the trajectory if measured, otherwise the drift of integrals.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.trajectory_error.or(self.integral_drift).expect("what is needed was measured")
    }
}

impl Traded {
    /// Returns the cheapest setting whose error is within the tolerance.
    #[must_use]
    pub fn choice(&self) -> Option<&Measured> {
        self.choice.as_ref().map(|choice| &choice.setting)
    }

    /// Describes the simulation: system, first point, time.
    #[must_use]
    pub fn title(&self) -> String {
        let point: Vec<String> = self.start.iter().map(ToString::to_string).collect();
        format!("{} from ({}) over {} units of time", self.system, point.join(", "), self.scene.horizon())
    }

    /// Returns the name of the error that the tolerance bounds.
    #[must_use]
    pub fn error_name(&self) -> &'static str {
        match self.scene.need() {
            Need::Trajectory => "trajectory error",
            Need::Integrals => "drift of integrals",
        }
    }
}

impl Trade {
    /// Asks for a trajectory with eight correct digits, measured within ten seconds.
    #[must_use]
    pub fn new(at: Vec<Rational>, horizon: Rational) -> Self {
        let (need, tolerance, seconds) = (trajectory(), usual_tolerance(), usual_seconds());
        Trade { at, horizon, need, tolerance, seconds }
    }

    /// Measures for at most the given seconds; ends earlier if the answer is clear.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, missing or nonpositive values, no clock, or nothing
    /// to measure.
    pub fn ask(&self, study: &Study, watch: &dyn Watch) -> Result<Traded, StudyError> {
        study.proved()?;
        let start = study.point(&self.at)?;
        let parameters = study.values()?;
        let horizon = positive("horizon", &self.horizon)?;
        let scene = Scene::new(horizon, self.need, positive("tolerance", &self.tolerance)?);
        if watch.now().is_none() {
            return Err(StudyError::NoClock);
        }
        let clock = || watch.now().unwrap_or_default();
        let trade = |why| StudyError::Trade { system: study.name().to_owned(), why };
        let runner = Runner::new(study.field(), &parameters, &start, &clock).map_err(trade)?;
        let search =
            RefinementSearch::of(&runner, study, &parameters, scene, self.seconds, watch).map_err(trade)?;
        Ok(search.finish(study, &parameters))
    }
}

fn positive(what: &'static str, value: &Rational) -> Result<f64, StudyError> {
    let float = value.to_f64();
    if float > 0.0 && float.is_finite() {
        Ok(float)
    } else {
        Err(StudyError::NotPositive { what, value: value.clone() })
    }
}

impl<'a> RefinementSearch<'a> {
    fn of(
        runner: &'a Runner<'a>,
        study: &Study,
        parameters: &[Rational],
        scene: Scene,
        seconds: f64,
        watch: &'a dyn Watch,
    ) -> Result<Self, CannotTrade> {
        let clock = runner.clock;
        // A time limit that `Duration` cannot represent is replaced by a very long one.
        let deadline =
            clock() + Duration::try_from_secs_f64(seconds).unwrap_or(UNLIMITED_TIME).min(UNLIMITED_TIME);
        let exact = |values: &[Rational]| values.iter().map(Rational::to_big).collect::<Vec<BigRational>>();
        let (exact_parameters, exact_start) = (exact(parameters), exact(&runner.start));
        let wide: Vec<Dd> = runner.start.iter().map(DoubleDouble::round).collect();
        let integrals = Integrals::of(runner, &wide);
        let reference = match scene.need() {
            Need::Integrals if integrals.is_empty() => return Err(CannotTrade::NoIntegrals),
            Need::Integrals => None,
            Need::Trajectory => {
                let is_over = || clock() > deadline;
                // Errors are measured in the variables of the original equations.
                let variables = Some(study.coordinates().len());
                // If ε is rounded up, the last point of an orbit lies after the horizon.
                let limits = TrajectoryLimits { margin: 1.0 / 256.0, variables, is_over: Some(&is_over) };
                let asked = Trajectory {
                    command: study.catalog_name().unwrap_or_default(),
                    parameters: &exact_parameters,
                    start: &exact_start,
                    end: scene.horizon(),
                    allowed: PART_OF_TOLERANCE * scene.tolerance(),
                };
                Some(Reference::of(&runner.wide, &asked, &limits).map_err(CannotTrade::Reference)?)
            }
        };
        // `coarsest` is the smallest number of steps to try. With fewer steps, ε would be too large
        // for the curvature of the reference or, without one, for ‖f′‖ at the start.
        let coarsest = match &reference {
            Some(reference) => 0.5 * reference.flow().turning() / 4.0,
            None => {
                let start: Vec<f64> = runner.start.iter().map(Rational::to_f64).collect();
                0.5 * scene.horizon() * rate(&runner.map.at(0.0), &start)
            }
        };
        let coarsest = coarsest.ceil().clamp(1.0, 1e15) as u64;
        let eps = scene.horizon() / (2.0 * coarsest as f64);
        let is_code = runner.is_code();
        let prices = if is_code {
            Prices::of(runner, 0.1 * eps, scene.horizon())
        } else {
            let stand_in = Runner::stand_in(clock)?;
            Prices::of(&stand_in, 0.01, f64::INFINITY).scaled(stand_in.wide.cost(), runner.wide.cost())
        };
        // Orbits are compared with the reference, so its own error reduces the tolerance.
        let certified = reference.as_ref().map_or(0.0, |reference| reference.certificate().difference);
        let tolerance = scene.tolerance() - certified;
        let measuring = SettingMeasurements {
            subject: runner,
            prices,
            scene,
            originals: study.coordinates().len(),
            reference,
            integrals,
            deadline,
            is_code,
            settings: Vec::new(),
            skipped: Vec::new(),
            watch,
        };
        let search = Search::new(measuring, tolerance, MEASURED);
        let mut ladders = RefinementSearch { search, tolerance, stalled: Vec::new() };
        ladders.run(coarsest);
        Ok(ladders)
    }

    fn finish(self, study: &Study, parameters: &[Rational]) -> Traded {
        let Self { search, tolerance, stalled } = self;
        let mut measuring = search.into_trials();
        let mut settings = std::mem::take(&mut measuring.settings);
        front::mark_pareto_front(&mut settings);
        for setting in settings.iter_mut().filter(|setting| setting.on_front) {
            setting.return_error = measuring.return_error(&setting.setting);
        }
        let SettingMeasurements { subject, scene, reference, is_code, skipped, .. } = measuring;
        let choice = settings.iter().find(|setting| setting.error() <= tolerance).map(|best| Choice {
            setting: best.clone(),
            rust: rust_code::rust_statement(study, parameters, &subject.start, &best.setting),
        });
        Traded {
            system: study.name().to_owned(),
            parameters: study.parameters().iter().cloned().zip(parameters.iter().cloned()).collect(),
            start: subject.start.clone(),
            scene,
            choice,
            certificate: reference.as_ref().map(Reference::certificate),
            scale: reference.as_ref().map(|reference| reference.flow().scale()),
            is_code,
            skipped,
            stalled,
            settings,
        }
    }
}

impl SettingMeasurements<'_> {
    /// Reports the number of measured settings to the watch. A cancellation sets the deadline to 0.
    fn tell(&mut self) {
        if self.deadline.is_zero() {
            return;
        }
        // The total is unknown, because the results decide which settings are measured.
        let progress = Progress { what: "settings", done: self.settings.len() as u64, of: None };
        if let ControlFlow::Break(()) = self.watch.look(&progress) {
            self.deadline = Duration::ZERO;
        }
    }
}

/// A duration that stands for no limit. Much longer ones would overflow the times of clocks.
const UNLIMITED_TIME: Duration = Duration::from_secs(1 << 32);
