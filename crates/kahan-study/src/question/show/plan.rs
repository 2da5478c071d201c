//! The costs of the generated functions, and the step as a straight-line program.

use kahan_algebra::derive;
use kahan_algebra::derived::{Derived, StepListing};
use kahan_algebra::plan::{Cost, StepPlan};
use kahan_algebra::system::System;
use kahan_discover::Watch;
use serde::Serialize;

use super::super::seconds_since;

/// The operation counts of a system's generated code, and the times to derive and plan the code.
#[derive(Clone, Debug, Serialize)]
pub struct ShownPlans {
    /// The name of the system.
    pub system: String,
    /// The cost of each generated function.
    pub objects: Vec<FunctionCost>,
    /// The step as a straight-line program; `None` if the step is Gaussian elimination in a loop.
    pub step: Option<Listing>,
    /// A step for all scalar types, if `step` multiplies by 1/ε and therefore works only in floats.
    pub general_step: Option<Listing>,
    /// The milliseconds of the derivation; `None` without a clock.
    pub derive_ms: Option<f64>,
    /// The milliseconds of planning the step; `None` without a clock.
    pub plan_ms: Option<f64>,
    /// The formulas and plans from which this answer was made.
    #[serde(skip)]
    pub derived: Derived,
}

/// The operation counts of a generated function; `None` if it is Gaussian elimination in a loop.
#[derive(Clone, Debug, Serialize)]
pub struct FunctionCost {
    /// A name for the result of the function.
    pub object: String,
    /// Additions, subtractions and negations.
    pub additions: Option<usize>,
    /// Multiplications.
    pub multiplications: Option<usize>,
    /// Multiply-adds.
    pub multiply_adds: Option<usize>,
    /// Divisions.
    pub divisions: Option<usize>,
    /// All operations, with each multiply-add counted as two.
    pub operations: Option<usize>,
    /// The length of the critical path in cycles.
    pub chain_cycles: Option<u32>,
}

/// A step as a straight-line program.
#[derive(Clone, Debug, Serialize)]
pub struct Listing {
    /// The instructions that depend only on ε and the parameters, and are run once for many steps.
    pub constants: Vec<String>,
    /// The instructions that compute, from a state, the numerators and 1/denominators of x̃ − x.
    pub kernel: Vec<String>,
    /// For each component, the name of 1/denominator of the increment; `None` without division.
    pub reciprocals: Vec<Option<String>>,
    /// The formulas of x̃, one for each component.
    pub next: Vec<String>,
    /// The size of ‖εf′‖∞ up to which the step is accurate: 1, 10, 100 or 1000; 0 if none of these.
    pub holds_to: u32,
}

impl ShownPlans {
    pub(super) fn of(name: &str, system: &System, watch: &dyn Watch) -> Self {
        let milliseconds = |begun| seconds_since(begun, watch).map(|seconds| 1e3 * seconds);
        let begun = watch.now();
        let derived = derive(system);
        let derive_ms = milliseconds(begun);
        let begun = watch.now();
        let listing = |step: &StepPlan| {
            let StepListing { constants, kernel, reciprocals, next, holds_to } =
                StepListing::of(step, &system.field.symbols);
            Listing { constants, kernel, reciprocals, next, holds_to }
        };
        let step = derived.step().map(listing);
        let plan_ms = milliseconds(begun);
        let inverse = derived.step().filter(|step| step.has_inverse_step);
        let general_step = inverse.map(|step| listing(step.for_any_step()));
        let objects = derived.functions().into_iter().map(|(object, plan)| {
            let cost: Option<Cost> = plan.map(|plan| plan.cost());
            FunctionCost {
                object,
                additions: cost.map(|cost| cost.additions),
                multiplications: cost.map(|cost| cost.multiplications),
                multiply_adds: cost.map(|cost| cost.fused),
                divisions: cost.map(|cost| cost.divisions),
                operations: cost.map(|cost| cost.operations()),
                chain_cycles: cost.map(|cost| cost.critical_path),
            }
        });
        ShownPlans {
            system: name.to_owned(),
            objects: objects.collect(),
            step,
            general_step,
            derive_ms,
            plan_ms,
            derived,
        }
    }
}
