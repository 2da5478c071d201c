//! Separates operations on ε and parameters from operations on states.

use crate::poly::Variable;

use crate::plan::{Input, Node, Operation, Plan, PlanBuilder};

/// Counts the outputs that depend on a product whose two factors both depend on ε. In general,
/// these outputs are rounded more than once.
pub(in crate::plan) fn derived_constants(plan: &Plan, epsilon: Variable) -> usize {
    let mut contains = vec![false; plan.operations.len()];
    let mut derived = vec![false; plan.operations.len()];
    for (index, operation) in plan.operations.iter().enumerate() {
        let operands: Vec<Node> = operation.operands().collect();
        contains[index] = matches!(operation, Operation::Input(Input::Variable(variable)) if *variable == epsilon)
            || operands.iter().any(|operand| contains[operand.0]);
        let both = operands.len() > 1 && operands.iter().all(|operand| contains[operand.0]);
        derived[index] = (both && matches!(operation, Operation::Multiply(..)))
            || operands.iter().any(|operand| derived[operand.0]);
    }
    plan.outputs.iter().filter(|output| derived[output.0]).count()
}

/// Splits a plan into two. The outputs of the first plan are the prepared constants of the second.
/// Exact numbers stay in the second plan.
#[must_use]
pub(in crate::plan) fn split(
    plan: &Plan,
    epsilon: Variable,
    varies: impl Fn(Variable) -> bool,
) -> (Plan, Plan) {
    // A zero divisor is a pole of the step, so divisions stay in the kernel. Divisions by ε do not,
    // because the caller checks that ε is not 0.
    let is_epsilon = |node: Node| plan.operations[node.0] == Operation::Input(Input::Variable(epsilon));
    split_where(plan, is_epsilon, varies)
}

/// Splits a plan like `split`, but moves divisions without states to the first plan, too.
#[must_use]
pub(crate) fn split_with_quotients(plan: &Plan, varies: impl Fn(Variable) -> bool) -> (Plan, Plan) {
    split_where(plan, |_| true, varies)
}

fn split_where(
    plan: &Plan,
    may_divide_by: impl Fn(Node) -> bool,
    varies: impl Fn(Variable) -> bool,
) -> (Plan, Plan) {
    let mut fixed = vec![true; plan.operations.len()];
    for (index, operation) in plan.operations.iter().enumerate() {
        fixed[index] = match operation {
            Operation::Input(Input::Variable(variable)) => !varies(*variable),
            Operation::Divide(_, divisor) if !may_divide_by(*divisor) => false,
            _ => operation.operands().all(|operand| fixed[operand.0]),
        };
    }
    let is_literal = |node: Node| match &plan.operations[node.0] {
        Operation::Constant(_) => true,
        Operation::Negate(a) => matches!(plan.operations[a.0], Operation::Constant(_)),
        _ => false,
    };
    let mut prepared: Vec<Node> = Vec::new();
    let mut kernel = PlanBuilder::default();
    let mut renamed: Vec<Option<Node>> = vec![None; plan.operations.len()];
    let mut needed: Vec<bool> = fixed.iter().map(|fixed| !fixed).collect();
    for output in &plan.outputs {
        needed[output.0] = true;
    }
    for (index, operation) in plan.operations.iter().enumerate().filter(|(index, _)| needed[*index]) {
        let mut prepare = |node: Node| {
            if renamed[node.0].is_none() {
                renamed[node.0] = Some(if is_literal(node) {
                    kernel.include_literal(plan, node)
                } else {
                    prepared.push(node);
                    kernel.prepared(prepared.len() - 1)
                });
            }
        };
        if fixed[index] {
            prepare(Node(index));
            continue;
        }
        for operand in operation.operands() {
            if fixed[operand.0] {
                prepare(operand);
            }
        }
        let operation =
            operation.with_operands(|operand| renamed[operand.0].expect("operands come before their uses"));
        renamed[index] = Some(kernel.push(operation));
    }
    let output = |output: &Node| renamed[output.0].expect("each output is in the kernel, or prepared");
    let outputs: Vec<Node> = plan.outputs.iter().map(output).collect();
    (Plan::of_results(&plan.operations, &prepared), kernel.finish(&outputs))
}
