//! What a step costs on this machine: nanoseconds, for every scheme.
//!
//! A system is timed by its code, which is as fast as the library's own, from the scene's own
//! point. Where there is no code, how fast a field is interpreted says nothing about how fast it
//! will be; so E6 is timed in its place, and each time scaled by what the plans say the two steps
//! cost. The ratios between orders are exact either way: an order is a number of stages.

use std::iter::once;

use kahan_core::{Need, Precision, Scheme, StepCost};

use super::runner::Runner;

/// Nanoseconds a step of every scheme.
#[derive(Clone, Debug)]
pub(super) struct Clock(Vec<(Scheme, f64)>);

/// Rounds, in each of which every scheme has its turn; the least time counts, since nothing makes a
/// step faster than it is.
const ROUNDS: usize = 15;
/// Stages a turn.
const STAGES: u64 = 2040;

impl Clock {
    /// Times every scheme, in turns.
    pub(super) fn of(subject: &Runner, eps: f64) -> Self {
        let mut clock = Clock(Scheme::all().map(|scheme| (scheme, f64::INFINITY)).collect());
        for _ in 0..ROUNDS {
            for (scheme, least) in &mut clock.0 {
                let stages = scheme.composition.stages() as u64;
                let is_wide = scheme.precision == Precision::DoubleDouble;
                let steps = STAGES / if is_wide { 5 * stages } else { stages };
                let (eps, end) = (scheme.precision.eps_near(eps, Need::Trajectory), &mut once(steps));
                let time = 1e9 * subject.follow(*scheme, eps, None, end, &mut |_, _| ()) / steps as f64;
                *least = least.min(time);
            }
        }
        clock
    }

    /// The times of a system with another step.
    pub(super) fn scaled(&self, measured: StepCost, asked: StepCost) -> Self {
        let ratio = |precision| match precision {
            // Hundreds of operations side by side: what counts is how many.
            Precision::DoubleDouble => f64::from(asked.operations) / f64::from(measured.operations),
            _ => asked.cycles() / measured.cycles(),
        };
        let scaled = |scheme: Scheme| self.nanoseconds(scheme) * ratio(scheme.precision);
        // How compilers pack steps in single precision is not foreseen, and has made them twice as
        // slow; they are never much faster.
        let at_least = |scheme: Scheme| match scheme.precision.is_single() {
            true => scaled(scheme).max(scaled(Scheme { precision: Precision::Double, ..scheme })),
            false => scaled(scheme),
        };
        Clock(Scheme::all().map(|scheme| (scheme, at_least(scheme))).collect())
    }

    /// Nanoseconds a step of the whole composition.
    pub(super) fn nanoseconds(&self, scheme: Scheme) -> f64 {
        self.0.iter().find(|(known, _)| *known == scheme).map_or(f64::INFINITY, |(_, time)| *time)
    }
}
