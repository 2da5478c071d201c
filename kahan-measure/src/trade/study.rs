//! One setting measured: an orbit is run, and at points along it compared with what it should be.

use std::iter::once;
use std::time::{Duration, Instant};

use kahan_core::Dd;

use crate::reference::Reference;

use super::clock::Clock;
use super::drift::{Drift, Integrals};
use super::kind::{Kind, ScalarKind};
use super::runner::Runner;
use super::stops::Stops;
use super::{Need, Setting};

/// Points at which integrals are evaluated beside, where the need is the trajectory.
const INTEGRAL_SAMPLES: usize = 32;

/// What measures settings of one scene, and remembers them.
pub(super) struct Study<'a> {
    pub(super) subject: &'a Runner,
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
    /// The error that the need is about, at about so many steps over the horizon; `None` where
    /// there is no time for it.
    pub(super) fn error(&mut self, kind: Kind, steps: u64) -> Option<f64> {
        // A power of 2 where the end is to be met more accurately than an ε that is rounded, to
        // `f64` for `dd` too, has it.
        let is_finer = (self.need, kind.scalar) == (Need::Trajectory, ScalarKind::Dd)
            && self.tolerance < 16.0 * f64::EPSILON;
        let steps = if is_finer { steps.next_power_of_two() } else { steps };
        let eps = kind.scalar.eps_near(self.horizon / (2.0 * steps as f64), self.need);
        let steps = ((self.horizon / (2.0 * eps)).round() as u64).max(1);
        let known = self.settings.iter().find(|known| known.kind == kind && known.eps == eps);
        if let Some(known) = known {
            return Some(known.error(self.need));
        }
        if self.expected(kind, eps, steps as f64) > self.deadline.saturating_duration_since(Instant::now()) {
            self.skip(kind, steps);
            return None;
        }
        let setting = self.measure(kind, eps, steps);
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
        self.expected(kind, self.horizon / (2.0 * steps), steps)
            > self.deadline.saturating_duration_since(Instant::now()).mul_f64(part)
    }

    fn expected(&self, kind: Kind, eps: f64, steps: f64) -> Duration {
        let seconds = if self.is_compiled {
            1e-9 * self.clock.nanoseconds(kind) * steps
        } else {
            const PROBE: u64 = 8;
            self.subject.follow(kind, eps, None, &mut once(PROBE), &mut |_, _| ()) * steps / PROBE as f64
        };
        Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX)
    }

    fn measure(&self, kind: Kind, eps: f64, steps: u64) -> Setting {
        let stops = Stops::of(self.reference.as_ref(), eps, steps);
        let (mut trajectory, mut samples) = (0.0_f64, 0_usize);
        let mut drift = Drift::new(self.subject, &self.integrals, eps);
        let has_integrals = !self.integrals.is_empty();
        let sparse = match self.need {
            Need::Trajectory => stops.len().div_ceil(INTEGRAL_SAMPLES),
            Need::Integrals => 1,
        };
        let dt = Dd::from(eps) * Dd::from(2.0);
        self.subject.follow(kind, eps, None, &mut stops.iter(), &mut |step, x| {
            if let Some(reference) = &self.reference {
                let t = dt * Dd::from(step as f64);
                if f64::from(t) <= reference.end() {
                    trajectory = trajectory.max(reference.distance(t, x));
                }
                if step == steps {
                    // The last point stands for the horizon.
                    trajectory = trajectory.max(reference.distance(Dd::from(self.horizon), x));
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
        let Setting { kind, eps, steps, .. } = *setting;
        if 2 * self.expected(kind, eps, steps as f64)
            > self.deadline.saturating_duration_since(Instant::now())
        {
            return None;
        }
        let ends = |eps: f64, from: Option<&[Dd]>| {
            let mut ends = Vec::with_capacity(2);
            self.subject.follow(kind, eps, from, &mut once(steps), &mut |_, x| ends.push(x.to_vec()));
            ends
        };
        let there = ends(eps, None);
        let (start, arrived) = (there.first()?, there.last()?);
        if !arrived.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let back = ends(-eps, Some(arrived)).pop()?;
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
        // Of two at one price the more accurate.
        let better = |a: &Setting, b: &Setting| {
            let (price, error) = (a.nanoseconds_per_unit_time, a.error(self.need));
            price.total_cmp(&b.nanoseconds_per_unit_time).then(error.total_cmp(&b.error(self.need)))
        };
        meets.min_by(|(_, a), (_, b)| better(a, b)).map(|(index, _)| index)
    }

    /// What the cheapest setting that meets the need costs; infinite where there is none.
    pub(super) fn least_cost(&self) -> f64 {
        self.best().map_or(f64::INFINITY, |best| self.settings[best].nanoseconds_per_unit_time)
    }
}
