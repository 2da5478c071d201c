//! Speed against accuracy, measured on one scene: which scalar, which order, compensated or not,
//! and which ε.
//!
//! In: a system, a point, a horizon, and what is needed of the orbit. Out: settings with their
//! price (nanoseconds a unit of simulated time, on this machine) and their error, the front that no
//! other setting beats, and the cheapest that meets the need. The library's own orbits are run and
//! timed; errors are against a certified [`Reference`].

mod catalog;
mod clock;
mod drift;
mod front;
mod kind;
mod runner;
mod search;
mod stops;
mod study;
mod walk;

use std::time::{Duration, Instant};

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_core::Dd;
use kahan_core::num_rational::BigRational;

use crate::reference::{Certificate, Limits, NoReference, Reference, Trajectory};
use kahan_runtime::interpreted::{CannotInterpret, UnsupportedDimension};

use clock::Clock;
use drift::Integrals;
use runner::Runner;
use study::Study;

pub use kind::{Kind, ORDERS, ScalarKind};

/// What an orbit is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Need {
    /// To follow the flow's trajectory: the error is the largest distance from it over the horizon,
    /// at the times of the steps and with the last point standing for the horizon, in the maximum
    /// norm, relative to the largest coordinate of the trajectory.
    Trajectory,
    /// To keep the integrals: the error is the largest change of the map's own (at its ε; of a
    /// composition, which has none of its own, of the flow's) over the horizon, relative to the
    /// value at the beginning.
    Integrals,
}

/// A scene.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The system.
    pub system: &'a System,
    /// Its name in the catalog; anything else for a field that is not compiled.
    pub command: &'a str,
    /// The parameters, in order.
    pub parameters: &'a [Rational],
    /// The first point.
    pub start: &'a [Rational],
    /// The time to be simulated, above 0.
    pub horizon: f64,
    /// What is needed.
    pub need: Need,
    /// The largest error that is accepted.
    pub tolerance: f64,
    /// The time that may be spent on it.
    pub seconds: f64,
}

/// A kind at an ε, measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The scalar, the order, the accumulation.
    pub kind: Kind,
    /// Half the time step; for [`Need::Integrals`] of so few bits that its powers are exact.
    pub eps: f64,
    /// The steps over the horizon.
    pub steps: u64,
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

/// What was measured.
#[derive(Clone, Debug)]
pub struct Trade {
    /// The settings, the cheapest first.
    pub settings: Vec<Setting>,
    /// The cheapest that meets the need.
    pub choice: Option<usize>,
    /// What stands behind the errors of trajectories.
    pub certificate: Option<Certificate>,
    /// What those errors are relative to.
    pub scale: Option<f64>,
    /// Whether prices were measured on this system's compiled steps; else on E6's, and scaled by
    /// the cost of the plans.
    pub is_compiled: bool,
    /// Kinds that there was no time for, and the ε from which on.
    pub skipped: Vec<(Kind, f64)>,
    /// Kinds that cannot: their errors fall no further, and stay above the tolerance.
    pub stalled: Vec<Kind>,
}

/// Why nothing was measured.
#[derive(Clone, Debug, PartialEq)]
pub enum CannotTrade {
    /// The system cannot be run.
    System(CannotInterpret),
    /// It has too many variables.
    Dimension(UnsupportedDimension),
    /// There is no reference trajectory.
    Reference(NoReference),
    /// The need is integrals, and the system declares none that depends on the state.
    NoIntegrals,
}

impl core::fmt::Display for CannotTrade {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::System(why) => why.fmt(f),
            Self::Dimension(why) => why.fmt(f),
            Self::Reference(why) => why.fmt(f),
            Self::NoIntegrals => f.write_str(
                "no integral is claimed without `when`, so there is none to keep; claim one in the field (`integral H = …;`), \
                 or ask for the need `trajectory`",
            ),
        }
    }
}

impl core::error::Error for CannotTrade {}

impl Setting {
    /// The error that a need is about; infinite where it was not measured.
    #[must_use]
    pub fn error(&self, need: Need) -> f64 {
        let error = match need {
            Need::Trajectory => self.trajectory_error,
            Need::Integrals => self.integral_drift,
        };
        error.unwrap_or(f64::INFINITY)
    }
}

impl Trade {
    /// Measures, calling `progress` with the number of settings known so far.
    ///
    /// # Errors
    /// [`CannotTrade`].
    pub fn of(scene: &Scene<'_>, progress: &mut dyn FnMut(u64)) -> Result<Self, CannotTrade> {
        let begin = Instant::now();
        let after =
            |part: f64| begin + Duration::try_from_secs_f64(part * scene.seconds).unwrap_or(LONG).min(LONG);
        let exact = |values: &[Rational]| values.iter().map(Rational::to_big).collect::<Vec<BigRational>>();
        let (parameters, start) = (exact(scene.parameters), exact(scene.start));
        let subject = &Runner::new(scene.system, scene.command, &parameters, &start)?;
        let wide = scene.start.iter().map(Rational::to_double_double);
        let wide: Vec<Dd> = wide.map(|(high, low)| Dd::new(high, low)).collect();
        let integrals = Integrals::of(subject, &wide);
        let reference = match scene.need {
            Need::Integrals if integrals.is_empty() => return Err(CannotTrade::NoIntegrals),
            Need::Integrals => None,
            Need::Trajectory => Some(reference(scene, subject, &parameters, &start, after(REFERENCE_SHARE))?),
        };
        // ε times the rate, on an average: compositions, whose stages are shorter, follow
        // trajectories up to 2 or so, with errors to match.
        let coarsest = match &reference {
            Some(reference) => 0.5 * reference.turning() / 4.0,
            None => 0.5 * scene.horizon * subject.slope(),
        };
        let coarsest = coarsest.ceil().clamp(1.0, 1e15) as u64;
        let eps = scene.horizon / (2.0 * coarsest as f64);
        let clock = if subject.is_compiled() {
            Clock::of(subject, 0.1 * eps)
        } else {
            let stand_in = Runner::stand_in()?;
            Clock::of(&stand_in, 0.01).scaled(stand_in.cost(), subject.cost())
        };
        let mut study = Study {
            subject,
            clock,
            need: scene.need,
            tolerance: scene.tolerance,
            horizon: scene.horizon,
            reference,
            integrals,
            deadline: after(1.0),
            is_compiled: subject.is_compiled(),
            settings: Vec::new(),
            skipped: Vec::new(),
            stalled: Vec::new(),
            progress,
        };
        study.search(coarsest);
        Ok(study.finish())
    }
}

/// The part of the time that a reference may take: without settings it is of no use.
const REFERENCE_SHARE: f64 = 0.75;
/// As good as no limit; a clock cannot tell times that are much later.
const LONG: Duration = Duration::from_secs(1 << 32);

/// The trajectory, a little beyond the horizon: n steps of an ε that was rounded do not end there
/// exactly.
fn reference(
    scene: &Scene<'_>,
    subject: &Runner,
    parameters: &[BigRational],
    start: &[BigRational],
    deadline: Instant,
) -> Result<Reference, CannotTrade> {
    let Scene { command, horizon: end, tolerance, .. } = *scene;
    let asked = Trajectory { command, parameters, start, end, allowed: 1e-3 * tolerance };
    let limits = Limits { margin: 1.0 / 256.0, deadline: Some(deadline) };
    subject.reference(&asked, &limits).map_err(CannotTrade::Reference)
}

impl Study<'_> {
    fn finish(mut self) -> Trade {
        self.settings.sort_by(|a, b| a.nanoseconds_per_unit_time.total_cmp(&b.nanoseconds_per_unit_time));
        front::mark(&mut self.settings, self.need);
        for index in 0..self.settings.len() {
            if self.settings[index].on_front {
                self.settings[index].return_error = self.return_error(&self.settings[index]);
            }
        }
        Trade {
            choice: self.best(),
            certificate: self.reference.as_ref().map(Reference::certificate),
            scale: self.reference.as_ref().map(Reference::scale),
            is_compiled: self.is_compiled,
            skipped: self.skipped,
            stalled: self.stalled,
            settings: self.settings,
        }
    }
}
