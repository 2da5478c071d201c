//! What each generated function costs, and the step in straight lines.

use kahan_algebra::derive;
use kahan_algebra::derived::{Derived, StepListing};
use kahan_algebra::plan::{Cost, StepPlan};
use kahan_algebra::system::System;
use kahan_discover::Watch;
use serde::Serialize;

use super::super::seconds_since;

/// The plans of a system's code, and how long it took to make them.
#[derive(Clone, Debug, Serialize)]
pub struct Planned {
    /// The name of the system.
    pub system: String,
    /// Each generated function with what it costs.
    pub objects: Vec<Costs>,
    /// The step in straight lines; `None` where it eliminates in a loop.
    pub step: Option<Listing>,
    /// The step that serves every scalar, where the other is divided by the time step.
    pub general_step: Option<Listing>,
    /// The milliseconds in which the map was derived; `None` without a clock.
    pub derive_ms: Option<f64>,
    /// The milliseconds in which the step was planned; `None` without a clock.
    pub plan_ms: Option<f64>,
    /// The plans.
    #[serde(skip)]
    pub derived: Derived,
}

/// A generated function and its operations; `None` where it eliminates in a loop.
#[derive(Clone, Debug, Serialize)]
pub struct Costs {
    /// What it computes.
    pub object: String,
    /// Additions, subtractions and negations.
    pub additions: Option<usize>,
    /// Multiplications.
    pub multiplications: Option<usize>,
    /// Multiply-adds: one operation where the target has them, else two.
    pub multiply_adds: Option<usize>,
    /// Divisions.
    pub divisions: Option<usize>,
    /// All operations of a target without multiply-adds.
    pub operations: Option<usize>,
    /// Cycles from the inputs to the last result, if nothing else hinders.
    pub chain_cycles: Option<u32>,
}

/// A step in straight lines.
#[derive(Clone, Debug, Serialize)]
pub struct Listing {
    /// What ε and the parameters fix, computed once.
    pub constants: Vec<String>,
    /// From a state to the numerators and reciprocals.
    pub kernel: Vec<String>,
    /// For each component the name of its reciprocal; `None` where it does not divide.
    pub reciprocals: Vec<Option<String>>,
    /// x̃ from x, a line a component.
    pub next: Vec<String>,
    /// The size |εf′| of a step up to which its error is near that of elimination.
    pub holds_to: u32,
}

impl Planned {
    /// Derives the map and plans the code of a system.
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
            Costs {
                object,
                additions: cost.map(|cost| cost.additions),
                multiplications: cost.map(|cost| cost.multiplications),
                multiply_adds: cost.map(|cost| cost.fused),
                divisions: cost.map(|cost| cost.divisions),
                operations: cost.map(|cost| cost.operations()),
                chain_cycles: cost.map(|cost| cost.critical_path),
            }
        });
        Planned {
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
