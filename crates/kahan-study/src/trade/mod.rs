//! Speed against accuracy, measured on one scene: which scalar, which order, compensated or not,
//! and which ε.
//!
//! In: a system, a point, a horizon, and what is needed of the orbit. Out: settings with their
//! price (nanoseconds a unit of simulated time, on this machine) and their error, the front that no
//! other setting beats, and the cheapest that meets the need. The library's own orbits are run and
//! timed; errors are against a certified [`Reference`].

mod drift;
mod front;
mod measure;
mod object;
mod paste;
mod prices;
mod runner;
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

use crate::error::StudyError;
pub use crate::map::CannotRun;
use crate::map::rate;
use crate::named::Names;
use crate::numbers::{DoubleDouble, Printable, exact};
use crate::reference::{Certificate, Limits, NoReference, PART_OF_TOLERANCE, Reference, Trajectory};
use crate::study::Study;

use drift::Integrals;
use measure::Measuring;
use prices::Prices;
use runner::Runner;
use search::{Ladders, MEASURED};

pub use object::need_name;

/// Asks which setting of the integrator serves one scene, and at what price.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Trade {
    /// The first point, a coordinate for each variable.
    #[serde(with = "exact")]
    pub at: Vec<Rational>,
    /// The time to be simulated, above 0.
    #[serde(with = "exact")]
    pub horizon: Rational,
    /// What the orbit is for: `trajectory` or `integrals`.
    #[serde(with = "object::NeedByName", default = "trajectory")]
    pub need: Need,
    /// The largest error that is accepted, above 0.
    #[serde(with = "exact", default = "usual_tolerance")]
    pub tolerance: Rational,
    /// The seconds that it may take.
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

/// A setting, measured.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Measured {
    /// The setting; what error to expect of it, this says.
    #[serde(flatten, serialize_with = "object::setting")]
    pub setting: Setting,
    /// The price.
    pub nanoseconds_per_unit_time: f64,
    /// The error of [`Need::Trajectory`]; `None` where it was not asked for. May be infinite.
    pub trajectory_error: Option<f64>,
    /// The error of [`Need::Integrals`]; `None` where none is declared.
    pub integral_drift: Option<f64>,
    /// The same of the flow's integrals.
    pub flow_integral_drift: Option<f64>,
    /// The distance from home after all steps forward and back, relative to the first point;
    /// measured on the front.
    pub return_error: Option<f64>,
    /// Whether no other setting is both cheaper and more accurate.
    pub on_front: bool,
}

/// What was measured, and on what.
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
    /// The horizon, the need and the tolerance.
    #[serde(flatten, serialize_with = "object::scene")]
    pub scene: Scene,
    /// What errors of trajectories are relative to.
    pub scale: Option<f64>,
    /// What stands behind the errors of trajectories.
    #[serde(rename = "reference")]
    pub certificate: Option<Certificate>,
    /// Whether prices were measured on this system's own steps, as code; else on E6's, and scaled
    /// by the cost of the plans.
    #[serde(rename = "timing", serialize_with = "object::timing")]
    pub is_code: bool,
    /// The settings, the cheapest first.
    pub settings: Vec<Measured>,
    /// The cheapest that meets the need.
    pub choice: Option<Choice>,
    /// Schemes that there was no time for, and the ε from which on.
    #[serde(serialize_with = "object::skipped")]
    pub skipped: Vec<(Scheme, f64)>,
    /// Schemes that cannot: their errors fall no further, and stay above the tolerance.
    #[serde(skip)]
    pub stalled: Vec<Scheme>,
}

/// The setting that was chosen.
#[derive(Clone, Debug, Serialize)]
pub struct Choice {
    /// The setting.
    #[serde(flatten)]
    pub setting: Measured,
    /// The setting as Rust to paste.
    pub rust: String,
}

/// Why nothing was measured.
#[derive(Clone, Debug, PartialEq)]
pub enum CannotTrade {
    /// The system cannot be run.
    CannotRun(CannotRun),
    /// There is no reference trajectory.
    Reference(NoReference),
    /// The need is integrals, and the system declares none that depends on the state.
    NoIntegrals,
}

impl core::fmt::Display for CannotTrade {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::CannotRun(why) => why.fmt(f),
            Self::Reference(why) => why.fmt(f),
            Self::NoIntegrals => f.write_str(
                "no integral is claimed without `when`, so there is none to keep; claim one in the field (`integral H = …;`), \
                 or ask for the need `trajectory`",
            ),
        }
    }
}

impl core::error::Error for CannotTrade {}

impl Measured {
    /// The error that the need is about: of the trajectory where it was asked for, else of the
    /// integrals.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.trajectory_error.or(self.integral_drift).expect("what is needed was measured")
    }
}

impl Traded {
    /// The cheapest setting that meets the need.
    #[must_use]
    pub fn choice(&self) -> Option<&Measured> {
        self.choice.as_ref().map(|choice| &choice.setting)
    }

    /// What was simulated, in words: system, first point, time.
    #[must_use]
    pub fn title(&self) -> String {
        let point: Vec<String> = self.start.iter().map(ToString::to_string).collect();
        format!("{} from ({}) over {} units of time", self.system, point.join(", "), self.scene.horizon())
    }

    /// What its errors are of.
    #[must_use]
    pub fn error_name(&self) -> &'static str {
        match self.scene.need() {
            Need::Trajectory => "trajectory error",
            Need::Integrals => "drift of integrals",
        }
    }
}

impl Trade {
    /// To follow a trajectory to eight digits, in ten seconds.
    #[must_use]
    pub fn new(at: Vec<Rational>, horizon: Rational) -> Self {
        let (need, tolerance, seconds) = (trajectory(), usual_tolerance(), usual_seconds());
        Trade { at, horizon, need, tolerance, seconds }
    }

    /// Measures for so many seconds, or less where the answer is clear before, on a system whose
    /// claims hold. Costs the time of the orbits that it runs; the watch must have a clock.
    ///
    /// # Errors
    /// [`StudyError`]: claims that do not hold, values that are missing or not above 0, no clock,
    /// or nothing that could be measured.
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
        let search = Ladders::of(&runner, study, &parameters, scene, self.seconds, watch).map_err(trade)?;
        Ok(search.finish(study, &parameters))
    }
}

/// A number above 0, as a float.
fn positive(what: &'static str, value: &Rational) -> Result<f64, StudyError> {
    let float = value.to_f64();
    if float > 0.0 && float.is_finite() {
        Ok(float)
    } else {
        Err(StudyError::NotPositive { what, value: value.clone() })
    }
}

impl<'a> Ladders<'a> {
    /// Measures.
    fn of(
        runner: &'a Runner<'a>,
        study: &Study,
        parameters: &[Rational],
        scene: Scene,
        seconds: f64,
        watch: &'a dyn Watch,
    ) -> Result<Self, CannotTrade> {
        let clock = runner.clock;
        // A time that is too long for a duration is as good as no limit.
        let deadline = clock() + Duration::try_from_secs_f64(seconds).unwrap_or(LONG).min(LONG);
        let exact = |values: &[Rational]| values.iter().map(Rational::to_big).collect::<Vec<BigRational>>();
        let (exact_parameters, exact_start) = (exact(parameters), exact(&runner.start));
        let wide: Vec<Dd> = runner.start.iter().map(DoubleDouble::round).collect();
        let integrals = Integrals::of(runner, &wide);
        let reference = match scene.need() {
            Need::Integrals if integrals.is_empty() => return Err(CannotTrade::NoIntegrals),
            Need::Integrals => None,
            Need::Trajectory => {
                // A little beyond the horizon: n steps of an ε that was rounded do not end there
                // exactly.
                let is_over = || clock() > deadline;
                // Errors are those of the variables that the equations have as they are written.
                let variables = Some(study.coordinates().len());
                let limits = Limits { margin: 1.0 / 256.0, variables, is_over: Some(&is_over) };
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
        // ε times the rate, on an average: compositions, whose stages are shorter, follow
        // trajectories up to 2 or so, with errors to match.
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
        // The possible error of the reference is taken off the tolerance.
        let certified = reference.as_ref().map_or(0.0, |reference| reference.certificate().difference);
        let tolerance = scene.tolerance() - certified;
        let measuring = Measuring {
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
        let mut ladders = Ladders { search, tolerance, stalled: Vec::new() };
        ladders.run(coarsest);
        Ok(ladders)
    }

    fn finish(self, study: &Study, parameters: &[Rational]) -> Traded {
        let Self { search, tolerance, stalled } = self;
        let mut measuring = search.into_trials();
        let mut settings = std::mem::take(&mut measuring.settings);
        front::mark(&mut settings);
        for setting in settings.iter_mut().filter(|setting| setting.on_front) {
            setting.return_error = measuring.return_error(&setting.setting);
        }
        let Measuring { subject, scene, reference, is_code, skipped, .. } = measuring;
        let choice = settings.iter().find(|setting| setting.error() <= tolerance).map(|best| Choice {
            setting: best.clone(),
            rust: paste::rust_of(study, parameters, &subject.start, &best.setting),
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

impl Measuring<'_> {
    /// Tells the watch how many settings are known; after it said stop, there is no time left, and
    /// it hears no more.
    fn tell(&mut self) {
        if self.deadline.is_zero() {
            return;
        }
        // How many there will be depends on what they show.
        let progress = Progress { what: "settings", done: self.settings.len() as u64, of: None };
        if let ControlFlow::Break(()) = self.watch.look(&progress) {
            self.deadline = Duration::ZERO;
        }
    }
}

/// As good as no limit; a clock cannot tell times that are much later.
const LONG: Duration = Duration::from_secs(1 << 32);
