//! The measured time of a step of each scheme on this machine, in nanoseconds.
//!
//! An interpreted field has no compiled step to time. Its times are those of the compiled system
//! E6, multiplied by the ratio of the estimated costs of the two systems' steps. A price in single
//! precision is at least that in double precision.

use kahan_core::StepCost;
use kahan_dynamics::{Need, Precision, Scheme};

use super::runner::Runner;

#[derive(Clone, Debug)]
pub(super) struct Prices(Vec<(Scheme, f64)>);

/// The number of rounds. Each round times every scheme once, and the shortest time is used.
const TIMING_ROUNDS: usize = 15;
const TIMED_STAGES: u64 = 2040;

impl Prices {
    /// Times every scheme in rounds. ε is at most `eps`, and so small that timed orbits end before
    /// `horizon`, because later states may be subnormal numbers, which are slow.
    pub(super) fn of(subject: &Runner<'_>, eps: f64, horizon: f64) -> Self {
        let mut prices = Prices(Scheme::all().map(|scheme| (scheme, f64::INFINITY)).collect());
        for _ in 0..TIMING_ROUNDS {
            for (scheme, least) in &mut prices.0 {
                let stages = scheme.composition.stages() as u64;
                let is_wide = scheme.precision == Precision::DoubleDouble;
                let steps = TIMED_STAGES / if is_wide { 5 * stages } else { stages };
                let eps = eps.min(horizon / (2.0 * steps as f64));
                // Step times do not depend on ε, so it is limited to the range of `f32`.
                let eps = scheme.precision.eps_near(eps.min(f64::from(f32::MAX)), Need::Trajectory);
                let time = 1e9 * subject.seconds(*scheme, eps, steps) / steps as f64;
                *least = least.min(time);
            }
        }
        // The user's compiler may vectorise steps in single precision, which has doubled their
        // time. Their prices are therefore at least those in double precision.
        for index in 0..prices.0.len() {
            let (scheme, time) = prices.0[index];
            if scheme.precision.is_single() {
                let double = prices.nanoseconds(Scheme { precision: Precision::Double, ..scheme });
                prices.0[index].1 = time.max(double);
            }
        }
        prices
    }

    /// Estimates the times of a step of cost `asked` from the times of a step of cost `measured`.
    pub(super) fn scaled(&self, measured: StepCost, asked: StepCost) -> Self {
        let ratio = |precision| match precision {
            // Double-double steps consist of many independent operations. Only their number counts.
            Precision::DoubleDouble => f64::from(asked.operations) / f64::from(measured.operations),
            _ => asked.cycles() / measured.cycles(),
        };
        let scaled = |scheme: Scheme| self.nanoseconds(scheme) * ratio(scheme.precision);
        Prices(Scheme::all().map(|scheme| (scheme, scaled(scheme))).collect())
    }

    pub(super) fn nanoseconds(&self, scheme: Scheme) -> f64 {
        let known = self.0.iter().find(|(known, _)| *known == scheme);
        known.map(|(_, time)| *time).expect("every scheme has been timed")
    }
}
