//! What a step costs, without a clock.
//!
//! In: what the plan of a step says of itself. Out: cycles. The factors are rounded from
//! measurements of the steps of E6, LV and the Euler top on x86-64 (`benches/results/tiers.json`);
//! they decide between kinds of numbers, whereas between orders and ε the count of stages does.

use kahan_core::StepCost;

use super::{Precision, Scheme};

/// An orbit in `f32` waits as long for its operations as one in `f64`.
const SINGLE: f64 = 1.0;
/// Conversions to and fro.
const SINGLE_THROUGH_DOUBLE: f64 = 1.25;
/// Seven operations a component, beside the chain from state to state.
const COMPENSATED: f64 = 1.1;
/// With fused multiply-adds an exact product takes two operations,
#[cfg(target_feature = "fma")]
const DOUBLE_DOUBLE: f64 = 6.0;
/// without them seventeen.
#[cfg(not(target_feature = "fma"))]
const DOUBLE_DOUBLE: f64 = 10.0;

impl Scheme {
    /// The modelled cycles of one step on a core of today, from what one of Kahan's map costs:
    /// stages × the [cycles](StepCost::cycles) of a stage in `f64` × what the numbers and the
    /// compensation cost more. Only ratios are meant.
    #[must_use]
    pub fn cycles(&self, stage: StepCost) -> f64 {
        let numbers = match self.precision {
            Precision::Single => SINGLE,
            Precision::SingleThroughDouble => SINGLE_THROUGH_DOUBLE,
            Precision::Double => 1.0,
            Precision::DoubleDouble => DOUBLE_DOUBLE,
        };
        let accumulation = if self.compensated { COMPENSATED } else { 1.0 };
        self.composition.stages() as f64 * stage.cycles() * numbers * accumulation
    }
}
