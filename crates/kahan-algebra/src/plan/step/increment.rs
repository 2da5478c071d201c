//! The increment of a single variable, divided at once: x̃ = x ± 2εn/d.
//!
//! A reciprocal that is shared by several components costs one division for all of them. A single
//! component gains nothing by it: the multiplication that follows would be on the way from each
//! state to the next, and would round once more, so that an orbit might miss a pole that it meets.

use crate::plan::{Node, Operation, PlanBuilder};

impl PlanBuilder {
    /// The numerator over the divisor of this reciprocal ±1/d or ±2/d; `None` for another one.
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
