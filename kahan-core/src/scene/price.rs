//! What a setting costs, without a clock.
//!
//! In: what the plan of a step says of itself. Out: cycles. The factors are rounded from
//! measurements of the steps of E6, LV and the Euler top on x86-64 (the tiers of `BENCHMARKS.md`);
//! they decide between kinds of numbers, whereas between orders and ε the count of stages does.

use crate::StepCost;

use super::Precision;
use super::setting::Kind;

/// An orbit in `f32` waits as long for its operations as one in `f64`.
const SINGLE: f64 = 1.0;
/// Conversions to and fro.
const SINGLE_THROUGH_DOUBLE: f64 = 1.25;
/// Seven operations a component, beside the chain from state to state.
const COMPENSATED: f64 = 1.1;
/// With fused multiply-adds an exact product takes two operations,
#[cfg(any(target_feature = "fma", target_arch = "aarch64"))]
const DOUBLE_DOUBLE: f64 = 6.0;
/// without them seventeen.
#[cfg(not(any(target_feature = "fma", target_arch = "aarch64")))]
const DOUBLE_DOUBLE: f64 = 10.0;

/// The cycles of one step.
pub(super) fn of_step(stage: StepCost, kind: Kind) -> f64 {
    let numbers = match kind.precision {
        Precision::Single => SINGLE,
        Precision::SingleThroughDouble => SINGLE_THROUGH_DOUBLE,
        Precision::Double => 1.0,
        Precision::DoubleDouble => DOUBLE_DOUBLE,
    };
    let accumulation = if kind.compensated { COMPENSATED } else { 1.0 };
    kind.composition.stages() as f64 * cycles(stage) * numbers * accumulation
}

/// The longer of what a step waits for and what it has to do, at two operations a cycle and four
/// cycles a division.
fn cycles(cost: StepCost) -> f64 {
    let (operations, divisions) = (f64::from(cost.operations), f64::from(cost.divisions));
    f64::from(cost.chain).max(operations / 2.0 + 4.0 * divisions)
}
