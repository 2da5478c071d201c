//! Every program of a system, made once and shared by its copies over all scalars.

use kahan_algebra::kahan::RationalMap;
use kahan_algebra::objects::{
    bilinear_plan, det_matrix_plan, field_jacobian_plan, field_plan, polarized_plan, rational_map_plan,
    reduced_map_plan,
};
use kahan_algebra::plan::{Plan, StepPlan};
use kahan_algebra::symbols::Symbols;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::System;
use kahan_core::__private::may_divide_by;
use kahan_core::{Scalar, StepCost};

use super::program::Program;

/// The programs of a system.
#[derive(Debug)]
pub(super) struct Code {
    pub(super) states: Vec<String>,
    pub(super) field: Program,
    pub(super) field_jacobian: Program,
    pub(super) bilinear: Program,
    pub(super) polarized: Program,
    /// `None` where every step eliminates.
    pub(super) step: Option<StepCode>,
    /// det A and (N, D), within the budget of terms.
    pub(super) closed_forms: Option<ClosedForms>,
    pub(super) integrals: Vec<Integral>,
    pub(super) cost: StepCost,
}

/// The programs of a step.
#[derive(Debug)]
pub(super) struct StepCode {
    pub(super) constants: Program,
    pub(super) kernel: Program,
    /// For each component the index of its reciprocal.
    pub(super) reciprocals: Vec<Option<usize>>,
    /// For scalars and ε that a step divided by ε does not serve.
    general: Option<Box<StepCode>>,
}

#[derive(Debug)]
pub(super) struct ClosedForms {
    pub(super) det_matrix: Program,
    /// The numerators, then the denominator.
    pub(super) rational_map: Program,
    /// The same, where a factor that depends on states is divided out.
    pub(super) reduced_map: Option<Program>,
}

/// An integral that was claimed without a condition.
#[derive(Debug)]
pub(super) struct Integral {
    pub(super) name: String,
    pub(super) program: Program,
}

impl Code {
    pub(super) fn of(system: &System) -> Self {
        let field = &system.field;
        let symbols = &field.symbols;
        let program = |plan: &Plan| Program::of(plan, symbols);
        let map = RationalMap::of(field);
        let step = StepPlan::of_map(field, map.as_ref());
        let integrals = system.accessors(ClaimKind::Integral);
        Code {
            states: symbols.states.clone(),
            field: program(&field_plan(field)),
            field_jacobian: program(&field_jacobian_plan(field)),
            bilinear: program(&bilinear_plan(field)),
            polarized: program(&polarized_plan(field)),
            closed_forms: map.as_ref().map(|map| ClosedForms {
                det_matrix: program(&det_matrix_plan(map)),
                rational_map: program(&rational_map_plan(map)),
                reduced_map: reduced_map_plan(field, map).as_ref().map(program),
            }),
            integrals: integrals
                .map(|claim| Integral { name: claim.name.text.clone(), program: program(&claim.plan) })
                .collect(),
            cost: step.as_ref().map_or(StepCost::of_elimination(field.dimension()), cost),
            step: step.map(|step| StepCode::of(&step, symbols)),
        }
    }
}

impl StepCode {
    fn of(plan: &StepPlan, symbols: &Symbols) -> Self {
        StepCode {
            constants: Program::of(&plan.constants, symbols),
            kernel: Program::of_kernel(&plan.kernel, symbols),
            reciprocals: plan.reciprocals.clone(),
            general: plan.has_inverse_step().then(|| Box::new(Self::of(plan.for_any_step(), symbols))),
        }
    }

    /// The programs that serve this ε.
    pub(super) fn at<T: Scalar>(&self, eps: &T) -> &Self {
        self.general.as_deref().filter(|_| !may_divide_by(eps)).unwrap_or(self)
    }
}

/// What generated code says that a step of this plan costs.
fn cost(plan: &StepPlan) -> StepCost {
    let count = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
    StepCost {
        operations: count(plan.operations()),
        divisions: count(plan.kernel.cost().divisions),
        chain: u32::try_from(plan.cycles()).unwrap_or(u32::MAX),
    }
}
