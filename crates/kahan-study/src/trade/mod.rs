//! Speed against accuracy, measured on one scene: which scalar, which order, compensated or not,
//! and which ε.
//!
//! In: a system, a point, a horizon, and what is needed of the orbit. Out: settings with their
//! price (nanoseconds a unit of simulated time, on this machine) and their error, the front that no
//! other setting beats, and the cheapest that meets the need. The library's own orbits are run and
//! timed; errors are against a certified [`Reference`].

mod clock;
mod drift;
mod front;
mod runner;
mod search;
mod stops;
mod study;

use std::time::{Duration, Instant};

use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;
use kahan_core::num_rational::BigRational;
use kahan_core::{Dd, Need, Scene, Scheme, Setting};

use crate::map::CannotRun;
use crate::reference::{Certificate, Limits, NoReference, PART_OF_TOLERANCE, Reference, Trajectory};

use clock::Clock;
use drift::Integrals;
use runner::Runner;
use search::SHARE;
use study::Study;

/// A system at a starting point.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The system.
    pub system: &'a System,
    /// Its name in the catalog, where it may have a closed solution; anything else for another
    /// field.
    pub command: &'a str,
    /// The parameters, in order.
    pub parameters: &'a [Rational],
    /// The first point.
    pub start: &'a [Rational],
}

/// A setting, measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The setting; what error to expect of it, this says.
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

/// What was measured.
#[derive(Clone, Debug)]
pub struct Trade {
    /// The settings, the cheapest first.
    pub settings: Vec<Measured>,
    /// The cheapest that meets the need.
    pub choice: Option<usize>,
    /// What stands behind the errors of trajectories.
    pub certificate: Option<Certificate>,
    /// What those errors are relative to.
    pub scale: Option<f64>,
    /// Whether prices were measured on this system's own steps, as code; else on E6's, and scaled
    /// by the cost of the plans.
    pub is_code: bool,
    /// Schemes that there was no time for, and the ε from which on.
    pub skipped: Vec<(Scheme, f64)>,
    /// Schemes that cannot: their errors fall no further, and stay above the tolerance.
    pub stalled: Vec<Scheme>,
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

impl Trade {
    /// Measures for so many seconds, or less where the answer is clear before, calling `progress`
    /// with the number of settings known so far.
    ///
    /// # Errors
    /// [`CannotTrade`].
    ///
    /// # Panics
    /// If the point has not a coordinate for every variable.
    pub fn of(
        subject: &Subject<'_>,
        scene: &Scene,
        seconds: f64,
        progress: &mut dyn FnMut(u64),
    ) -> Result<Self, CannotTrade> {
        // A time that is too long for a duration is as good as no limit.
        let deadline = Instant::now() + Duration::try_from_secs_f64(seconds).unwrap_or(LONG).min(LONG);
        let Subject { system, command, parameters, start } = *subject;
        let exact = |values: &[Rational]| values.iter().map(Rational::to_big).collect::<Vec<BigRational>>();
        let (exact_parameters, exact_start) = (exact(parameters), exact(start));
        let subject = &Runner::new(system, parameters, start)?;
        let wide = start.iter().map(Rational::to_double_double);
        let wide: Vec<Dd> = wide.map(|(high, low)| Dd::new(high, low)).collect();
        let integrals = Integrals::of(subject, &wide);
        let reference = match scene.need() {
            Need::Integrals if integrals.is_empty() => return Err(CannotTrade::NoIntegrals),
            Need::Integrals => None,
            Need::Trajectory => {
                // A little beyond the horizon: n steps of an ε that was rounded do not end there
                // exactly.
                let limits = Limits { margin: 1.0 / 256.0, deadline: Some(deadline) };
                let asked = Trajectory {
                    command,
                    parameters: &exact_parameters,
                    start: &exact_start,
                    end: scene.horizon(),
                    allowed: PART_OF_TOLERANCE * scene.tolerance(),
                };
                Some(subject.map.reference(&asked, &limits).map_err(CannotTrade::Reference)?)
            }
        };
        // ε times the rate, on an average: compositions, whose stages are shorter, follow
        // trajectories up to 2 or so, with errors to match.
        let coarsest = match &reference {
            Some(reference) => 0.5 * reference.flow().turning() / 4.0,
            None => 0.5 * scene.horizon() * subject.map.slope(start),
        };
        let coarsest = coarsest.ceil().clamp(1.0, 1e15) as u64;
        let eps = scene.horizon() / (2.0 * coarsest as f64);
        let clock = if subject.is_code() {
            Clock::of(subject, 0.1 * eps, scene.horizon())
        } else {
            let stand_in = Runner::stand_in()?;
            Clock::of(&stand_in, 0.01, f64::INFINITY).scaled(stand_in.map.cost(), subject.map.cost())
        };
        let mut study = Study {
            subject,
            clock,
            scene: *scene,
            // What the reference may err by is not there to be used.
            tolerance: scene.tolerance()
                - reference.as_ref().map_or(0.0, |reference| reference.certificate().difference),
            reference,
            integrals,
            deadline,
            share: SHARE,
            is_code: subject.is_code(),
            settings: Vec::new(),
            skipped: Vec::new(),
            stalled: Vec::new(),
            progress,
        };
        study.search(coarsest);
        Ok(study.finish())
    }
}

/// As good as no limit; a clock cannot tell times that are much later.
const LONG: Duration = Duration::from_secs(1 << 32);

impl Study<'_> {
    fn finish(mut self) -> Trade {
        front::mark(&mut self.settings);
        for index in 0..self.settings.len() {
            if self.settings[index].on_front {
                self.settings[index].return_error = self.return_error(&self.settings[index].setting);
            }
        }
        Trade {
            choice: self.best(),
            certificate: self.reference.as_ref().map(Reference::certificate),
            scale: self.reference.as_ref().map(|reference| reference.flow().scale()),
            is_code: self.is_code,
            skipped: self.skipped,
            stalled: self.stalled,
            settings: self.settings,
        }
    }
}
