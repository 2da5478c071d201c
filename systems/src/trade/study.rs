//! One setting measured: an orbit is run, and at points along it compared with what it should be.

use std::time::{Duration, Instant};

use kahan_core::Dd;

use crate::reference::Reference;

use super::clock::Clock;
use super::drift::{Drift, Integrals};
use super::kind::Kind;
use super::runner::{Run, Runner};
use super::{Need, Setting};

/// Points along an orbit that are looked at.
const SAMPLES: u64 = 512;
/// Points at which integrals are evaluated beside, where the need is the trajectory.
const INTEGRAL_SAMPLES: u64 = 32;

/// What measures settings of one scene, and remembers them.
pub(super) struct Study<'a> {
    pub(super) subject: &'a dyn Runner,
    pub(super) clock: Clock,
    pub(super) need: Need,
    pub(super) tolerance: f64,
    pub(super) horizon: f64,
    pub(super) reference: Option<Reference>,
    pub(super) integrals: Integrals,
    pub(super) deadline: Instant,
    /// Whether the clock tells how long a step takes here: fields are interpreted, and take longer.
    pub(super) is_compiled: bool,
    pub(super) settings: Vec<Setting>,
    /// The first kinds and steps that there was no time for.
    pub(super) skipped: Vec<(Kind, f64)>,
    /// Kinds whose errors fell no further, above the tolerance.
    pub(super) stalled: Vec<Kind>,
    pub(super) progress: &'a mut dyn FnMut(u64),
}

impl Study<'_> {
    /// The error that the need is about, at about so many steps over the horizon; `None` where there is no time for it.
    pub(super) fn error(&mut self, kind: Kind, steps: u64) -> Option<f64> {
        let eps = kind.scalar.eps_near(self.horizon / (2.0 * steps as f64), self.need);
        let steps = ((self.horizon / (2.0 * eps)).round() as u64).max(1);
        let known = self.settings.iter().find(|known| known.kind == kind && known.eps == eps);
        if let Some(known) = known {
            return Some(known.error(self.need));
        }
        let run = Run { eps, steps };
        if self.expected(kind, run) > self.deadline.saturating_duration_since(Instant::now()) {
            self.skip(kind, steps);
            return None;
        }
        let setting = self.measure(kind, run);
        let error = setting.error(self.need);
        self.settings.push(setting);
        (self.progress)(self.settings.len() as u64);
        Some(error)
    }

    /// Remembers from which number of steps on there was no time for a kind.
    pub(super) fn skip(&mut self, kind: Kind, steps: u64) {
        if self.skipped.iter().all(|(skipped, _)| *skipped != kind) {
            self.skipped.push((kind, kind.scalar.eps_near(self.horizon / (2.0 * steps as f64), self.need)));
        }
    }

    /// Whether so many steps take more than this part of the time that is left.
    pub(super) fn takes_more_than(&self, part: f64, kind: Kind, steps: f64) -> bool {
        let run = Run { eps: self.horizon / (2.0 * steps), steps: steps as u64 };
        self.expected(kind, run) > self.deadline.saturating_duration_since(Instant::now()).mul_f64(part)
    }

    fn expected(&self, kind: Kind, run: Run) -> Duration {
        let seconds = if self.is_compiled {
            1e-9 * self.clock.nanoseconds(kind) * run.steps as f64
        } else {
            const PROBE: u64 = 8;
            let probe = Run { steps: PROBE, ..run };
            self.subject.follow(kind, probe, None, PROBE, &mut |_, _| ()) * run.steps as f64 / PROBE as f64
        };
        Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX)
    }

    fn measure(&self, kind: Kind, run: Run) -> Setting {
        let Run { eps, steps } = run;
        let (mut trajectory, mut samples) = (0.0_f64, 0_u64);
        let mut drift = Drift::new(self.subject, &self.integrals, eps);
        let has_integrals = !self.integrals.is_empty();
        let sparse = match self.need {
            Need::Trajectory => SAMPLES / INTEGRAL_SAMPLES,
            Need::Integrals => 1,
        };
        let dt = Dd::from(eps) * Dd::from(2.0);
        self.subject.follow(kind, run, None, steps.div_ceil(SAMPLES), &mut |step, x| {
            if let Some(reference) = &self.reference {
                let t = dt * Dd::from(step as f64);
                if f64::from(t) <= reference.end() {
                    trajectory = trajectory.max(reference.distance(t, x));
                }
            }
            if has_integrals && (samples.is_multiple_of(sparse) || step == steps) {
                drift.visit(x);
            }
            samples += 1;
        });
        let (own, flow) = drift.finish();
        Setting {
            kind,
            eps,
            steps,
            nanoseconds_per_unit_time: self.clock.nanoseconds(kind) / (2.0 * eps),
            trajectory_error: self.reference.as_ref().map(|_| trajectory),
            // A composition has no integrals of its own: it is to keep the flow's.
            integral_drift: has_integrals.then_some(if kind.order == 2 { own } else { flow }),
            flow_integral_drift: has_integrals.then_some(flow),
            return_error: None,
            on_front: false,
        }
    }

    /// How far a setting comes from home, there and back, relative to the first point's size.
    pub(super) fn return_error(&self, setting: &Setting) -> Option<f64> {
        let run = Run { eps: setting.eps, steps: setting.steps };
        if 2 * self.expected(setting.kind, run) > self.deadline.saturating_duration_since(Instant::now()) {
            return None;
        }
        let ends = |run: Run, from: Option<&[Dd]>| {
            let mut ends = Vec::with_capacity(2);
            self.subject.follow(setting.kind, run, from, run.steps, &mut |_, x| ends.push(x.to_vec()));
            ends
        };
        let there = ends(run, None);
        let (start, arrived) = (there.first()?, there.last()?);
        if !arrived.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let back = ends(Run { eps: -run.eps, ..run }, Some(arrived)).pop()?;
        let norm =
            |x: &mut dyn Iterator<Item = Dd>| x.map(|entry| f64::from(entry.abs())).fold(0.0, f64::max);
        let size = norm(&mut start.iter().copied());
        let distance = norm(&mut start.iter().zip(&back).map(|(start, back)| *back - *start));
        Some(if size > 0.0 { distance / size } else { distance }).filter(|error| error.is_finite())
    }

    /// What a kind costs at so many steps.
    pub(super) fn cost(&self, kind: Kind, steps: u64) -> f64 {
        self.clock.nanoseconds(kind) * steps as f64 / self.horizon
    }

    /// The cheapest setting that meets the need.
    pub(super) fn best(&self) -> Option<usize> {
        let meets = self.settings.iter().enumerate();
        let meets = meets.filter(|(_, setting)| setting.error(self.need) <= self.tolerance);
        let cost = |setting: &Setting| setting.nanoseconds_per_unit_time;
        meets.min_by(|(_, a), (_, b)| cost(a).total_cmp(&cost(b))).map(|(index, _)| index)
    }

    /// What the cheapest setting that meets the need costs; infinite where there is none.
    pub(super) fn least_cost(&self) -> f64 {
        self.best().map_or(f64::INFINITY, |best| self.settings[best].nanoseconds_per_unit_time)
    }
}
