//! What a step costs on this machine: nanoseconds, for every scheme.
//!
//! A system is timed by its code, which is as fast as the library's own, from the scene's own
//! point. Where there is no code, how fast a field is interpreted says nothing about how fast it
//! will be; so E6 is timed in its place, and each time scaled by what the plans say the two steps
//! cost. The ratios between orders are exact either way: an order is a number of stages.

use kahan_core::StepCost;
use kahan_dynamics::{Need, Precision, Scheme};

use super::runner::Runner;

/// Nanoseconds a step of every scheme.
#[derive(Clone, Debug)]
pub(super) struct Prices(Vec<(Scheme, f64)>);

/// Rounds, in each of which every scheme has its turn; the least time counts, since nothing makes a
/// step faster than it is.
const ROUNDS: usize = 15;
/// Stages a turn.
const STAGES: u64 = 2040;

impl Prices {
    /// Times every scheme, in turns, with this ε, or a smaller one where a turn would go beyond the
    /// horizon: numbers that are too small there, as what decays becomes, take a step a hundred
    /// times as long.
    pub(super) fn of(subject: &Runner<'_>, eps: f64, horizon: f64) -> Self {
        let mut prices = Prices(Scheme::all().map(|scheme| (scheme, f64::INFINITY)).collect());
        for _ in 0..ROUNDS {
            for (scheme, least) in &mut prices.0 {
                let stages = scheme.composition.stages() as u64;
                let is_wide = scheme.precision == Precision::DoubleDouble;
                let steps = STAGES / if is_wide { 5 * stages } else { stages };
                let eps = eps.min(horizon / (2.0 * steps as f64));
                // How long a step takes is the same with an ε within the range of `f32`.
                let eps = scheme.precision.eps_near(eps.min(f64::from(f32::MAX)), Need::Trajectory);
                let time = 1e9 * subject.seconds(*scheme, eps, steps) / steps as f64;
                *least = least.min(time);
            }
        }
        // A compiler packs steps in single precision, which has made them twice as slow as this
        // code is, and never much faster.
        for index in 0..prices.0.len() {
            let (scheme, time) = prices.0[index];
            if scheme.precision.is_single() {
                let double = prices.nanoseconds(Scheme { precision: Precision::Double, ..scheme });
                prices.0[index].1 = time.max(double);
            }
        }
        prices
    }

    /// The times of a system with another step.
    pub(super) fn scaled(&self, measured: StepCost, asked: StepCost) -> Self {
        let ratio = |precision| match precision {
            // Hundreds of operations side by side: what counts is how many.
            Precision::DoubleDouble => f64::from(asked.operations) / f64::from(measured.operations),
            _ => asked.cycles() / measured.cycles(),
        };
        let scaled = |scheme: Scheme| self.nanoseconds(scheme) * ratio(scheme.precision);
        Prices(Scheme::all().map(|scheme| (scheme, scaled(scheme))).collect())
    }

    /// Nanoseconds a step of the whole composition.
    pub(super) fn nanoseconds(&self, scheme: Scheme) -> f64 {
        let known = self.0.iter().find(|(known, _)| *known == scheme);
        known.map(|(_, time)| *time).expect("every scheme has been timed")
    }
}
