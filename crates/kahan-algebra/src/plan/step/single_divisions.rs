//! Each component divided for itself: x̃ᵢ = xᵢ ± 2εnᵢ/d, without the multiplication that follows a
//! shared reciprocal.
//!
//! In an orbit that multiplication is on the way from each state to the next. Two quotients by one
//! divisor are a single instruction over two lanes, as fast as one division; a third would have to
//! wait.

use crate::plan::step::signs::{Wanted, with_signs};
use crate::plan::{Kernel, Node, Operation, PlanBuilder, StepPlan};

/// The quotients that one instruction gives.
pub(in crate::plan) const TOGETHER: usize = 2;

impl StepPlan {
    /// The step with a division a component; `None` where there is no reciprocal that serves all of
    /// them, and nothing else, or where there are too many components.
    pub(in crate::plan) fn with_single_divisions(&self) -> Option<Self> {
        let (plan, dimension) = (&self.kernel.plan, self.kernel.dimension());
        let [reciprocal] = self.kernel.reciprocals() else { return None };
        let is_used = plan.operations.iter().any(|step| step.operands().any(|node| node == *reciprocal));
        let Operation::Divide(dividend, divisor) = plan.operations[reciprocal.0] else { return None };
        let Operation::Constant(dividend) = &plan.operations[dividend.0] else { return None };
        if dimension > TOGETHER || is_used {
            return None;
        }
        let is_negative = dividend.is_negative();
        let doubles = match dividend.abs().as_i64() {
            Some(1) => false,
            Some(2) => true,
            _ => return None,
        };
        let mut builder = PlanBuilder::default();
        let steps = builder.include_all(plan);
        let ready = plan.ready();
        let mut outputs = Vec::with_capacity(dimension);
        for (numerator, reciprocal) in self.kernel.factors(&plan.outputs) {
            if reciprocal.is_none() {
                outputs.push(steps[numerator.0]);
                continue;
            }
            let (size, is_negated) = match plan.operations[numerator.0] {
                Operation::Negate(size) => (size, true),
                _ => (*numerator, false),
            };
            let dividend = match plan.operations[size.0] {
                _ if !doubles => steps[size.0],
                // The factor that is there first is doubled while the other one is computed.
                Operation::Multiply(a, b) => {
                    let (first, last) = if ready[a.0] <= ready[b.0] { (a, b) } else { (b, a) };
                    let first = twice(&mut builder, steps[first.0]);
                    builder.multiply(first, steps[last.0])
                }
                _ => twice(&mut builder, steps[size.0]),
            };
            let quotient = builder.divide(dividend, steps[divisor.0]);
            outputs.push(if is_negated != is_negative { builder.negate(quotient) } else { quotient });
        }
        // No reciprocal takes a sign any more.
        let (constants, plan) =
            with_signs(self.constants.clone(), builder.finish(&outputs), Wanted::Additions);
        let kernel = Kernel { plan, reciprocal_of: vec![None; dimension] };
        Some(StepPlan { constants, kernel, ..self.clone() })
    }
}

/// 2a, by an addition.
fn twice(builder: &mut PlanBuilder, a: Node) -> Node {
    builder.intern(Operation::Add(a, a))
}
