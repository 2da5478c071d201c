//! What each generated function costs, and the step in straight lines.

use kahan_algebra::derive;
use kahan_algebra::derived::{Derived, StepListing};
use kahan_algebra::plan::{Cost, StepPlan};
use kahan_algebra::system::System;
use kahan_discover::Watch;
use serde::{Serialize, Serializer};

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

/// A generated function and its operations.
#[derive(Clone, Debug)]
pub struct Costs {
    /// What it computes.
    pub object: String,
    /// What that costs; `None` where it eliminates in a loop.
    pub cost: Option<Cost>,
}

/// A step in three parts: constants, kernel, next state.
#[derive(Clone, Debug)]
pub struct Listing(pub StepListing);

impl Planned {
    /// Derives the map and plans the code of a system.
    pub(super) fn of(name: &str, system: &System, watch: &dyn Watch) -> Self {
        let milliseconds = |begun| seconds_since(begun, watch).map(|seconds| 1e3 * seconds);
        let begun = watch.now();
        let derived = derive(system);
        let derive_ms = milliseconds(begun);
        let begun = watch.now();
        let listing = |step: &StepPlan| Listing(StepListing::of(step, &system.field.symbols));
        let step = derived.step().map(listing);
        let plan_ms = milliseconds(begun);
        let inverse = derived.step().filter(|step| step.has_inverse_step);
        let general_step = inverse.map(|step| listing(step.for_any_step()));
        let objects = derived.functions().into_iter();
        let objects = objects.map(|(object, plan)| Costs { object, cost: plan.map(|plan| plan.cost()) });
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

impl Serialize for Costs {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Object<'a> {
            object: &'a str,
            additions: Option<usize>,
            multiplications: Option<usize>,
            multiply_adds: Option<usize>,
            divisions: Option<usize>,
            operations: Option<usize>,
            chain_cycles: Option<u32>,
        }
        let cost = self.cost;
        let object = Object {
            object: &self.object,
            additions: cost.map(|cost| cost.additions),
            multiplications: cost.map(|cost| cost.multiplications),
            multiply_adds: cost.map(|cost| cost.fused),
            divisions: cost.map(|cost| cost.divisions),
            operations: cost.map(|cost| cost.operations()),
            chain_cycles: cost.map(|cost| cost.critical_path),
        };
        object.serialize(serializer)
    }
}

impl Serialize for Listing {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Object<'a> {
            constants: &'a [String],
            kernel: &'a [String],
            reciprocals: &'a [Option<String>],
            next: &'a [String],
            holds_to: u32,
        }
        let StepListing { constants, kernel, reciprocals, next, holds_to } = &self.0;
        Object { constants, kernel, reciprocals, next, holds_to: *holds_to }.serialize(serializer)
    }
}
