//! Measures a setting: runs an orbit, and compares points with the reference and integrals with
//! their first values.

use std::iter::once;
use std::ops::ControlFlow;
use std::time::Duration;

use kahan_core::Dd;
use kahan_discover::Watch;
use kahan_dynamics::search::Trials;
use kahan_dynamics::{Need, Scene, Scheme, Setting};

use crate::reference::Reference;

use super::Measured;
use super::drift::{Drift, Integrals};
use super::prices::Prices;
use super::runner::Runner;
use super::stops::inspected_steps;

/// The approximate number of points at which integrals are evaluated along a trajectory.
const INTEGRAL_SAMPLES: usize = 32;

pub(super) struct SettingMeasurements<'a> {
    pub(super) subject: &'a Runner<'a>,
    pub(super) prices: Prices,
    pub(super) scene: Scene,
    /// The number of leading variables in which errors are measured.
    pub(super) originals: usize,
    pub(super) reference: Option<Reference>,
    pub(super) integrals: Integrals,
    pub(super) deadline: Duration,
    /// Whether the steps run as machine code.
    pub(super) is_code: bool,
    pub(super) settings: Vec<Measured>,
    /// For each scheme that ran out of time, the ε of the first setting that was not measured.
    pub(super) skipped: Vec<(Scheme, f64)>,
    pub(super) watch: &'a dyn Watch,
}

impl Trials for SettingMeasurements<'_> {
    fn setting(&self, scheme: Scheme, steps: u64) -> Setting {
        self.scene.setting(scheme, steps)
    }

    fn error(&mut self, setting: &Setting, share: f64) -> Option<f64> {
        if !(setting.eps() > 0.0 && setting.eps().is_finite()) {
            // ε is beyond the range of `f32`, so the error counts as infinite.
            return Some(f64::INFINITY);
        }
        let (scheme, steps) = (setting.scheme(), setting.steps());
        if self.gives_up(scheme, steps, steps as f64, share) {
            return None;
        }
        let Some(measured) = self.measure(*setting) else {
            self.record_skipped(scheme, steps);
            return None;
        };
        let error = measured.error();
        self.settings.push(measured);
        self.tell();
        Some(error)
    }

    fn price(&self, scheme: Scheme) -> f64 {
        self.prices.nanoseconds(scheme)
    }

    fn cost(&self, setting: &Setting) -> f64 {
        let steps = match self.scene.need() {
            Need::Trajectory => setting.steps() as f64,
            // If only integrals matter, the orbit ends at the step nearest to the simulated time.
            Need::Integrals => 0.5 * self.scene.horizon() / setting.eps(),
        };
        self.price(setting.scheme()) * steps
    }

    fn gives_up(&mut self, scheme: Scheme, next: u64, end: f64, share: f64) -> bool {
        let eps = self.scene.horizon() / (2.0 * end);
        let is_late = self.expected(scheme, eps, end) > self.time_left().mul_f64(share);
        if is_late {
            self.record_skipped(scheme, next);
        }
        is_late
    }
}

impl SettingMeasurements<'_> {
    /// Records that a scheme had no time for this number of steps. Only the first record is kept.
    fn record_skipped(&mut self, scheme: Scheme, steps: u64) {
        if self.skipped.iter().all(|(skipped, _)| *skipped != scheme) {
            self.skipped.push((scheme, self.scene.setting(scheme, steps).eps()));
        }
    }

    /// Removes and returns the schemes that ran out of time, so that they can be tried again.
    pub(super) fn take_skipped(&mut self) -> Vec<(Scheme, f64)> {
        std::mem::take(&mut self.skipped)
    }

    fn time_left(&self) -> Duration {
        self.deadline.saturating_sub((self.subject.clock)())
    }

    fn expected(&self, scheme: Scheme, eps: f64, steps: f64) -> Duration {
        let seconds = if self.is_code {
            1e-9 * self.prices.nanoseconds(scheme) * steps
        } else {
            const PROBE_STEPS: u64 = 8;
            self.subject.seconds(scheme, eps, PROBE_STEPS) * steps / PROBE_STEPS as f64
        };
        Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX)
    }

    fn measure(&self, setting: Setting) -> Option<Measured> {
        let (scheme, eps, steps) = (setting.scheme(), setting.eps(), setting.steps());
        let stops = inspected_steps(self.reference.as_ref(), eps, steps);
        let (mut trajectory, mut samples) = (0.0_f64, 0_usize);
        let mut drift = Drift::new(self.subject, &self.integrals, eps);
        let has_integrals = !self.integrals.is_empty();
        let sparse = match self.scene.need() {
            Need::Trajectory => stops.len().div_ceil(INTEGRAL_SAMPLES),
            Need::Integrals => 1,
        };
        let dt = Dd::from(eps) * Dd::from(2.0);
        let mut is_over = false;
        self.subject.follow(scheme, eps, None, &mut stops.iter().copied(), &mut |step, x| {
            is_over = step < steps && self.time_left().is_zero();
            if is_over {
                return ControlFlow::Break(());
            }
            if let Some(reference) = &self.reference {
                let t = dt * Dd::from(step as f64);
                if f64::from(t) <= reference.flow().end() {
                    trajectory = trajectory.max(reference.distance(t, x));
                }
                if step == steps {
                    // The last point is also compared with the trajectory at the horizon.
                    trajectory = trajectory.max(reference.distance(Dd::from(self.scene.horizon()), x));
                }
            }
            if has_integrals && (samples.is_multiple_of(sparse) || step == steps) {
                drift.visit(x);
            }
            samples += 1;
            ControlFlow::Continue(())
        });
        if is_over {
            return None;
        }
        let [own, flow] = drift.most;
        let trajectory_error = self.reference.as_ref().map(|_| trajectory);
        // Kahan's map preserves its own integrals; compositions nearly preserve those of the flow.
        let integral_drift = has_integrals.then_some(if scheme.order() == 2 { own } else { flow });
        Some(Measured {
            setting,
            nanoseconds_per_unit_time: self.prices.nanoseconds(scheme) / (2.0 * eps),
            trajectory_error,
            integral_drift,
            flow_integral_drift: has_integrals.then_some(flow),
            return_error: None,
            on_front: false,
        })
    }

    /// Returns the distance from the start after all steps forward and back, relative to the start;
    /// `None` if too little time is left, or if a number is not finite.
    pub(super) fn return_error(&self, setting: &Setting) -> Option<f64> {
        let (scheme, eps, steps) = (setting.scheme(), setting.eps(), setting.steps());
        if 2 * self.expected(scheme, eps, steps as f64) > self.time_left() {
            return None;
        }
        let ends = |eps: f64, from: Option<&[Dd]>| {
            let mut ends = Vec::with_capacity(2);
            self.subject.follow(scheme, eps, from, &mut once(steps), &mut |_, x| {
                ends.push(x.to_vec());
                ControlFlow::Continue(())
            });
            ends
        };
        let there = ends(eps, None);
        let (start, arrived) = (there.first()?, there.last()?);
        if !arrived.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let back = ends(-eps, Some(arrived)).pop()?;
        let norm = |x: &mut dyn Iterator<Item = Dd>| {
            x.take(self.originals).map(|entry| f64::from(entry.abs())).fold(0.0, f64::max)
        };
        let size = norm(&mut start.iter().copied());
        let distance = norm(&mut start.iter().zip(&back).map(|(start, back)| *back - *start));
        Some(if size > 0.0 { distance / size } else { distance }).filter(|error| error.is_finite())
    }
}
