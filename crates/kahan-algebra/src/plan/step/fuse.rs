//! Multiply-adds: where a product is used once, in a sum, and the critical path does not become
//! longer.
//!
//! A multiply-add saves an instruction and takes 4 cycles from the last of its operands, where an
//! addition takes 3. So it is right unless the addend comes late on the critical path that
//! everything waits for.

use crate::plan::cost::{ADD, FUSED};
use crate::plan::{Node, Operation, Plan};

impl Plan {
    /// The plan with multiply-adds. On targets without them it is carried out as before.
    #[must_use]
    pub(crate) fn fused(mut self) -> Self {
        let mut uses = self.uses();
        let required = self.required();
        let mut ready = vec![0; self.operations.len()];
        for index in 0..self.operations.len() {
            if let Some(fused) = self.fusable(index, &uses, &ready, required[index]) {
                for operand in self.operations[index].operands() {
                    if !fused.operands().any(|kept| kept == operand) {
                        uses[operand.0] -= 1;
                    }
                }
                self.operations[index] = fused;
            }
            let operation = &self.operations[index];
            let operands = operation.operands().map(|Node(index)| ready[index]).max().unwrap_or(0);
            ready[index] = operands + operation.latency();
        }
        Plan::together([&self])
    }

    fn fusable(&self, index: usize, uses: &[usize], ready: &[u32], required: u32) -> Option<Operation> {
        let product = |node: Node| match self.operations[node.0] {
            Operation::Multiply(a, b) if uses[node.0] == 1 => Some((a, b)),
            _ => None,
        };
        let at = |node: Node| ready[node.0];
        let candidate = match self.operations[index] {
            Operation::Add(a, b) => {
                // Of two products the later one is fused: the earlier one is there when it begins.
                let (late, early) = if at(a) > at(b) { (a, b) } else { (b, a) };
                match (product(late), product(early)) {
                    (Some((x, y)), _) => Some(Operation::MultiplyAdd(x, y, early)),
                    (None, Some((x, y))) => Some(Operation::MultiplyAdd(x, y, late)),
                    (None, None) => None,
                }
            }
            Operation::Subtract(a, b) => match (product(a), product(b)) {
                (Some((x, y)), _) if at(a) > at(b) => Some(Operation::MultiplySubtract(x, y, b)),
                (_, Some((x, y))) => Some(Operation::SubtractProduct(a, x, y)),
                (Some((x, y)), None) => Some(Operation::MultiplySubtract(x, y, b)),
                (None, None) => None,
            },
            _ => None,
        }?;
        let fused = candidate.operands().map(at).max().unwrap_or(0) + FUSED;
        let unfused = self.operations[index].operands().map(at).max().unwrap_or(0) + ADD;
        (fused <= required.max(unfused)).then_some(candidate)
    }

    /// The latest cycle in which each operation may be ready without making the plan's critical
    /// path longer.
    pub(in crate::plan) fn required(&self) -> Vec<u32> {
        let critical_path = self.cost().critical_path;
        let mut required = vec![critical_path; self.operations.len()];
        for (index, operation) in self.operations.iter().enumerate().rev() {
            let latest = required[index].saturating_sub(operation.latency());
            for operand in operation.operands() {
                required[operand.0] = required[operand.0].min(latest);
            }
        }
        required
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::PlanBuilder;
    use crate::poly::Variable;

    #[test]
    fn a_product_that_is_added_once_is_fused() {
        let mut builder = PlanBuilder::default();
        let [x, y, z] = [0, 1, 2].map(|v| builder.input(Variable(v)));
        let product = builder.multiply(x, y);
        let sum = builder.subtract(z, product);
        let cost = builder.finish(&[sum]).fused().cost();
        assert_eq!((cost.fused, cost.operations(), cost.critical_path), (1, 2, FUSED));
        // A product with another use stays.
        let cost = builder.finish(&[sum, product]).fused().cost();
        assert_eq!((cost.fused, cost.operations()), (0, 2));
    }

    /// Of two products the one that is ready last is fused, since its partner waits for it anyway.
    #[test]
    fn the_later_of_two_products_is_fused() {
        let mut builder = PlanBuilder::default();
        let [x, y] = [0, 1].map(|v| builder.input(Variable(v)));
        let product = builder.multiply(x, y);
        let cube = builder.multiply(product, x);
        let square = builder.multiply(y, y);
        let sum = builder.add(square, cube);
        let cost = builder.finish(&[sum]).fused().cost();
        assert_eq!((cost.fused, cost.operations(), cost.critical_path), (1, 4, 4 + FUSED));
    }

    /// Fused, the sum would be ready a cycle later, and everything waits for it.
    #[test]
    fn a_late_addend_on_the_chain_is_not_fused() {
        let mut builder = PlanBuilder::default();
        let [x, y, z] = [0, 1, 2].map(|v| builder.input(Variable(v)));
        let early = builder.multiply(x, y);
        let late = builder.divide(x, z);
        let sum = builder.add(late, early);
        let plan = builder.finish(&[sum]);
        assert_eq!(plan.clone().fused(), plan);
    }
}
