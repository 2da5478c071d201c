//! The modelled cost of a step, in processor cycles.
//!
//! The factors are rounded from measured steps of the systems E6, LV and Euler top on x86-64
//! (`benches/results/tiers.json`).

use kahan_core::StepCost;

use super::{Precision, Scheme};

/// The cost factor of `f32`. The operations of a single orbit take as long as in `f64`.
const SINGLE_COST_FACTOR: f64 = 1.0;
/// The cost factor of a state in `f32` with steps in `f64`, which need conversions.
const SINGLE_THROUGH_DOUBLE: f64 = 1.25;
/// The cost factor of compensation, which adds seven operations for each component.
const COMPENSATION_COST_FACTOR: f64 = 1.1;
/// The cost factor of `Dd` with fused multiply-adds, where an exact product takes two operations.
#[cfg(target_feature = "fma")]
const DOUBLE_DOUBLE_COST_FACTOR: f64 = 6.0;
/// The cost factor of `Dd` without fused multiply-adds, where an exact product takes 17 operations.
#[cfg(not(target_feature = "fma"))]
const DOUBLE_DOUBLE_COST_FACTOR: f64 = 10.0;

impl Scheme {
    /// Returns the modelled processor cycles of one step. Only ratios of results are meaningful.
    ///
    /// The result is the product of the number of stages, the [cycles](StepCost::cycles) of one
    /// `stage` (a step of Kahan's map) in `f64`, and the factors of scalar and compensation.
    #[must_use]
    pub fn cycles(&self, stage: StepCost) -> f64 {
        let numbers = match self.precision {
            Precision::Single => SINGLE_COST_FACTOR,
            Precision::SingleThroughDouble => SINGLE_THROUGH_DOUBLE,
            Precision::Double => 1.0,
            Precision::DoubleDouble => DOUBLE_DOUBLE_COST_FACTOR,
        };
        let accumulation = if self.compensated { COMPENSATION_COST_FACTOR } else { 1.0 };
        self.composition.stages() as f64 * stage.cycles() * numbers * accumulation
    }
}
