//! Chooses the sign of each reciprocal, c/d or −c/d, so that few numerators are negated.
//!
//! Rounding is symmetric, so no bit of x̃ changes. In code for floats, the compiler turns
//! x + (−n)·r into x − n·r; other scalars must compute the negation.

use kahan_syntax::rational::Rational;

use crate::plan::{Kernel, Node, Operation, Plan, PlanBuilder};

/// Chooses the signs of reciprocals such that few numerators need a negation. The cost is
/// proportional to operations · components.
#[must_use]
pub(in crate::plan) fn with_signs_of_reciprocals(kernel: Kernel) -> Kernel {
    let plan = &kernel.plan;
    let first =
        |reciprocal: Option<&Node>| reciprocal.and_then(|reciprocal| first_division(plan, *reciprocal));
    let bases: Vec<Option<Node>> =
        kernel.factors(&plan.outputs).map(|(_, reciprocal)| first(reciprocal)).collect();
    let votes = |of: Node| {
        let mut balance = 0;
        for (numerator, _) in kernel.numerators().iter().zip(&bases).filter(|(_, base)| **base == Some(of)) {
            balance += match &plan.operations[numerator.0] {
                Operation::Negate(_) => 1,
                Operation::Constant(value) if value.is_zero() => 0,
                _ => -1,
            };
        }
        balance
    };
    let is_turned =
        |base: &Option<Node>| base.is_some_and(|base| votes(base) > 0 && is_only_divided(plan, base));
    let turned: Vec<bool> = bases.iter().map(is_turned).collect();
    if !turned.contains(&true) {
        return kernel;
    }
    let is_turned_base =
        |node: Node| bases.iter().zip(&turned).any(|(base, turned)| *turned && *base == Some(node));
    let mut builder = PlanBuilder::default();
    let renamed = builder.include_with(plan, |builder, index, renamed| {
        let mut turned = plan.operations[index].with_operands(|node| renamed[node.0]);
        if let Operation::Divide(dividend, _) = &mut turned
            && is_turned_base(Node(index))
            && let Some(literal) = dividend_of(plan, Node(index))
        {
            *dividend = builder.push(Operation::Constant(-literal));
        }
        builder.push(turned)
    });
    let mut outputs: Vec<Node> = plan.outputs.iter().map(|output| renamed[output.0]).collect();
    for (output, _) in outputs.iter_mut().zip(&turned).filter(|(_, turned)| **turned) {
        *output = builder.changed_sign(*output);
    }
    Kernel { plan: builder.finish(&outputs), ..kernel }
}

pub(in crate::plan) fn is_reciprocal(plan: &Plan, node: Node) -> bool {
    first_division(plan, node).is_some()
}

/// Returns the node c/d of a reciprocal, which is c/d or (c/d)/d′.
fn first_division(kernel: &Plan, reciprocal: Node) -> Option<Node> {
    if dividend_of(kernel, reciprocal).is_some() {
        return Some(reciprocal);
    }
    match kernel.operations[reciprocal.0] {
        Operation::Divide(dividend, _) => first_division(kernel, dividend),
        _ => None,
    }
}

fn dividend_of(kernel: &Plan, quotient: Node) -> Option<&Rational> {
    let Operation::Divide(dividend, _) = kernel.operations[quotient.0] else { return None };
    match &kernel.operations[dividend.0] {
        Operation::Constant(literal) => Some(literal),
        _ => None,
    }
}

/// Returns whether a quotient is used only as a dividend.
fn is_only_divided(kernel: &Plan, quotient: Node) -> bool {
    let uses = |user: &Operation| user.operands().any(|operand| operand == quotient);
    kernel.operations.iter().enumerate().filter(|(_, user)| uses(user)).all(|(index, user)| {
        matches!(user, Operation::Divide(dividend, divisor) if *dividend == quotient && *divisor != quotient)
            && is_only_divided(kernel, Node(index))
    })
}
