//! Every program of a system, made once and shared by its copies over all scalars.

use kahan_algebra::derived::Derived;
use kahan_algebra::plan::{self, Plan, StepPlan};
use kahan_algebra::symbols::Symbols;
use kahan_core::__private::may_divide_by;
use kahan_core::{Scalar, StepCost};

use super::program::Program;

/// The programs of a system.
#[derive(Debug)]
pub(crate) struct Code {
    pub(super) states: Vec<String>,
    pub(super) field: Program,
    pub(super) field_jacobian: Program,
    pub(super) bilinear: Program,
    pub(super) polarized: Program,
    /// `None` where every step eliminates.
    pub(super) step: Option<StepCode>,
    /// det A, within the budget of terms.
    pub(super) det_matrix: Option<Program>,
    /// The numerators, then the denominator, within the budget.
    pub(super) rational_map: Option<Program>,
    /// The same, where a factor that depends on states is divided out.
    pub(super) reduced_map: Option<Program>,
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

/// An integral that was claimed without a condition.
#[derive(Debug)]
pub(super) struct Integral {
    pub(super) name: String,
    pub(super) program: Program,
}

impl Code {
    pub(crate) fn of(derived: &Derived) -> Self {
        let symbols = &derived.system.field.symbols;
        let program = |plan: &Plan| Program::of(plan, symbols);
        let perhaps = |plan: &Option<Plan>| plan.as_ref().map(program);
        let integral = |(index, name): (usize, &String)| Integral {
            name: name.clone(),
            program: program(&derived.integrals.result(index)),
        };
        let elimination = StepCost::of_elimination(symbols.dimension());
        Code {
            states: symbols.states.clone(),
            field: program(&derived.field),
            field_jacobian: program(&derived.field_jacobian),
            bilinear: program(&derived.bilinear),
            polarized: program(&derived.polarized),
            det_matrix: perhaps(&derived.det_matrix),
            rational_map: perhaps(&derived.rational_map),
            reduced_map: perhaps(&derived.reduced_map),
            integrals: derived.integral_names.iter().enumerate().map(integral).collect(),
            cost: derived.step().map_or(elimination, |step| cost(step.cost())),
            step: derived.step().map(|step| StepCode::of(step, symbols)),
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

fn cost(plan::StepCost { operations, divisions, chain }: plan::StepCost) -> StepCost {
    StepCost { operations, divisions, chain }
}
