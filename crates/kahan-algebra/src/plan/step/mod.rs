//! The plan of a step. Constants are prepared once for ε and the parameters, and a kernel runs at
//! each state.
//!
//! - `split` separates prepared constants from the `kernel`.
//! - `signs` and `reciprocals` choose signs in the kernel.
//! - `recurrence` measures the cycles of a step.

pub(in crate::plan) mod kernel;
pub(in crate::plan) mod reciprocals;
pub(in crate::plan) mod recurrence;
pub(in crate::plan) mod signs;
pub(in crate::plan) mod split;

use crate::arithmetic::OverRationals;
use crate::field::Field;
use crate::symbols::Symbols;

use self::split::split;
use crate::plan::step::reciprocals::with_signs_of_reciprocals;
use crate::plan::step::signs::with_signs;
use crate::plan::{Input, Kernel, Node, Operation, Plan, PlanBuilder};

/// The largest ‖εf′‖∞ at which the planner measures the accuracy of a step.
pub const LARGEST_SIZE: u32 = 1000;

/// The cost of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepCost {
    /// The number of operations of a step, where a multiply-add is two operations.
    pub operations: u32,
    /// The number of divisions among the operations.
    pub divisions: u32,
    /// The number of cycles of a step in a long orbit.
    pub critical_path: u32,
}

/// The straight-line plan of a step x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepPlan {
    /// The plan of the prepared constants, which are computed once from ε and the parameters.
    pub constants: Plan,
    /// The operations that are repeated for each state.
    pub kernel: Kernel,
    /// Whether a prepared constant has the divisor ε. If so, the plan can be used only for floats,
    /// and only if ε is not near zero.
    pub has_inverse_step: bool,
    /// The plan for SIMD lanes, if another plan is faster there. A second division can make one
    /// orbit faster, but in SIMD lanes divisions are the bottleneck. If `self` [divides by
    /// ε](Self::has_inverse_step), `general` also serves other scalars and ε near zero.
    pub general: Option<Box<StepPlan>>,
    /// The step was tested at the sizes ‖εf′‖∞ = 1, 10, 100, 1000. Up to `holds_to`, it loses few
    /// digits compared with elimination with partial pivoting; 0 means that it loses more at the
    /// size 1. Errors are measured at random points with a fixed seed.
    pub holds_to: u32,
}

impl StepPlan {
    /// Returns the plan for this arithmetic and this ε.
    #[must_use]
    pub fn at<A: OverRationals>(&self, arithmetic: &A, eps: &A::Value) -> &Self {
        if arithmetic.is_moderate(eps) { self } else { self.for_any_step() }
    }

    /// Returns the plan for every scalar and every ε.
    #[must_use]
    pub fn for_any_step(&self) -> &Self {
        self.general.as_deref().filter(|_| self.has_inverse_step).unwrap_or(self)
    }

    /// Returns the number of operations of a step. The number includes products with reciprocals
    /// and the last additions.
    #[must_use]
    pub fn operations(&self) -> usize {
        let products = self.kernel.reciprocal_of.iter().flatten().count();
        self.kernel.plan.cost().operations() + products + self.kernel.dimension()
    }

    /// Returns the cost of the step.
    #[must_use]
    pub fn cost(&self) -> StepCost {
        let count = |n: u64| u32::try_from(n).expect("plans have a budget of terms");
        StepCost {
            operations: count(self.operations() as u64),
            divisions: count(self.kernel.plan.cost().divisions as u64),
            critical_path: count(self.cycles()),
        }
    }

    /// Returns the plan of x̃ from x and the prepared constants. A numerator −n is not negated: n
    /// times its reciprocal is subtracted from x, as a compiler would do.
    #[must_use]
    pub fn next(&self, symbols: &Symbols) -> Plan {
        let mut operations = self.kernel.plan.operations.clone();
        let mut push = |operation: Operation| {
            operations.push(operation);
            Node(operations.len() - 1)
        };
        let mut outputs = Vec::with_capacity(self.kernel.dimension());
        for (i, (&numerator, reciprocal)) in self.kernel.factors(&self.kernel.plan.outputs).enumerate() {
            let state = push(Operation::Input(Input::Variable(symbols.state(i))));
            let negated = match self.kernel.plan.operations[numerator.0] {
                Operation::Negate(inner) => Some(inner),
                _ => None,
            };
            outputs.push(push(match (negated, reciprocal.copied()) {
                (Some(inner), Some(reciprocal)) => Operation::SubtractProduct(state, inner, reciprocal),
                (Some(inner), None) => Operation::Subtract(state, inner),
                (None, Some(reciprocal)) => Operation::MultiplyAdd(numerator, reciprocal, state),
                (None, None) => Operation::Add(state, numerator),
            }));
        }
        Plan::together([&Plan { operations, outputs }])
    }

    /// Returns whether generated code must keep values out of vector registers.
    ///
    /// The answer is yes for three components only. There, moves between registers would take up to
    /// an eighth of the time of a step. With more components, code that prevents such moves would
    /// make the step too large for inlining.
    #[must_use]
    pub fn fences_values(&self) -> bool {
        self.kernel.dimension() == 3
    }

    pub(in crate::plan) fn new(
        builder: &PlanBuilder,
        field: &Field,
        numerators: &[Node],
        reciprocals: &[Option<Node>],
    ) -> Self {
        if let ([numerator], [Some(reciprocal)]) = (numerators, reciprocals)
            && recurrence::earliest(builder.operations(), *reciprocal, field.symbols.state(0)).is_some()
        {
            let mut builder = builder.clone();
            if let Some(increment) = builder.increment(*numerator, *reciprocal) {
                return Self::new(&builder, field, &[increment], &[None]);
            }
        }
        let mut distinct: Vec<Node> = Vec::new();
        let places = reciprocals.iter().map(|reciprocal| {
            let reciprocal = (*reciprocal)?;
            Some(distinct.iter().position(|&known| known == reciprocal).unwrap_or_else(|| {
                distinct.push(reciprocal);
                distinct.len() - 1
            }))
        });
        let places: Vec<Option<usize>> = places.collect();
        let outputs: Vec<Node> = numerators.iter().chain(&distinct).copied().collect();
        let (constants, kernel) = split(&builder.finish(&outputs), field.symbols.epsilon(), |variable| {
            field.symbols.is_state(variable)
        });
        let (constants, kernel) = with_signs(constants, kernel.fused());
        let kernel = with_signs_of_reciprocals(Kernel { plan: kernel, reciprocal_of: places });
        // `constants` divides only by ε, because reciprocals of parameters are its inputs.
        let has_inverse_step =
            constants.operations.iter().any(|operation| matches!(operation, Operation::Divide(..)));
        StepPlan { constants, kernel, has_inverse_step, general: None, holds_to: LARGEST_SIZE }
    }

    #[must_use]
    pub(crate) fn mapped(self, change: &dyn Fn(&Plan) -> Plan) -> Self {
        let general = self.general.map(|general| Box::new(general.mapped(change)));
        StepPlan { constants: change(&self.constants), general, ..self }
    }
}

impl PlanBuilder {
    /// Writes the step of a field with one variable by a direct division: x̃ = x ± 2εn/d. Returns
    /// `None` unless the reciprocal is ±1/d or ±2/d.
    ///
    /// Multiplication by a reciprocal would delay the next step and round once more.
    pub(super) fn increment(&mut self, numerator: Node, reciprocal: Node) -> Option<Node> {
        let Operation::Divide(dividend, divisor) = self.operations()[reciprocal.0] else { return None };
        let Operation::Constant(dividend) = &self.operations()[dividend.0] else { return None };
        let is_negative = dividend.is_negative();
        let dividend = match dividend.abs().as_i64()? {
            1 => numerator,
            2 => self.push(Operation::Add(numerator, numerator)),
            _ => return None,
        };
        let quotient = self.divide(dividend, divisor);
        Some(if is_negative { self.changed_sign(quotient) } else { quotient })
    }
}
