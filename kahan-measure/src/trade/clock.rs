//! What a step costs on this machine: nanoseconds, for every kind.
//!
//! A system of the catalog is timed as the library steps it, from the scene's own point. A field
//! that is given as text has no compiled code, and how fast it is interpreted says nothing about
//! how fast it will be; so E6 is timed in its place, and each time scaled by what the plans say the
//! two steps cost. The ratios between orders are exact either way: an order is a number of stages.

use std::collections::HashMap;
use std::iter::once;

use kahan_core::StepCost;

use super::Need;
use super::kind::{Kind, ScalarKind};
use super::runner::Runner;

/// Nanoseconds a step.
#[derive(Clone, Debug)]
pub(super) struct Clock(HashMap<Kind, f64>);

/// Rounds, in each of which every kind has its turn; the least time counts, since nothing makes a
/// step faster than it is.
const ROUNDS: usize = 15;
/// Stages a turn.
const STAGES: u64 = 2040;

impl Clock {
    /// Times every kind, in turns.
    pub(super) fn of(subject: &Runner, eps: f64) -> Self {
        let mut nanoseconds: HashMap<Kind, f64> = HashMap::new();
        for _ in 0..ROUNDS {
            for kind in Kind::all() {
                let stages = kind.composition().stages() as u64;
                let steps = STAGES / if kind.scalar == ScalarKind::Dd { 5 * stages } else { stages };
                let (eps, end) = (kind.scalar.eps_near(eps, Need::Trajectory), &mut once(steps));
                let time = 1e9 * subject.follow(kind, eps, None, end, &mut |_, _| ()) / steps as f64;
                let least = nanoseconds.entry(kind).or_insert(time);
                *least = least.min(time);
            }
        }
        Clock(nanoseconds)
    }

    /// The times of a system with another step.
    pub(super) fn scaled(self, measured: StepCost, asked: StepCost) -> Self {
        let ratio = |scalar| match scalar {
            // Hundreds of operations side by side: what counts is how many.
            ScalarKind::Dd => f64::from(asked.operations) / f64::from(measured.operations),
            _ => cycles(asked) / cycles(measured),
        };
        let scaled =
            Clock(self.0.into_iter().map(|(kind, time)| (kind, time * ratio(kind.scalar))).collect());
        // How compilers pack steps in single precision is not foreseen, and has made them twice as
        // slow; they are never much faster.
        let at_least = |kind: Kind| match kind.scalar {
            ScalarKind::F32 | ScalarKind::F32ThroughF64 => {
                scaled.nanoseconds(kind).max(scaled.nanoseconds(Kind { scalar: ScalarKind::F64, ..kind }))
            }
            _ => scaled.nanoseconds(kind),
        };
        Clock(scaled.0.keys().map(|kind| (*kind, at_least(*kind))).collect())
    }

    /// Nanoseconds a step of the whole composition.
    pub(super) fn nanoseconds(&self, kind: Kind) -> f64 {
        self.0.get(&kind).copied().unwrap_or(f64::INFINITY)
    }
}

/// The longer of what a step waits for and what it has to do, at two operations a cycle and four
/// cycles a division.
fn cycles(cost: StepCost) -> f64 {
    let (operations, divisions) = (f64::from(cost.operations), f64::from(cost.divisions));
    f64::from(cost.chain).max(operations / 2.0 + 4.0 * divisions)
}
