//! A step over dual numbers, written out: how generated code computes ∂x̃/∂x.
//!
//! Each step of a plan becomes a value and n derivatives by the rules of `kahan_core`'s `Dual`: products take
//! u′v + uv′, quotients (u′ − (u/v)v′)/v with one reciprocal, and a multiply-add is a product and a sum. Zero derivatives
//! are computed with like any others, for so does a float, which cannot know that 0·v is 0.

use crate::field::Field;
use crate::plan::{Node, Operation, Plan, StepPlan};
use crate::poly::Variable;
use crate::rational::Rational;
use crate::symbols::Symbol;

/// A value and its derivatives.
#[derive(Clone, Debug)]
struct DualNode {
    value: Node,
    gradient: Vec<Node>,
}

/// A plan over dual numbers under construction.
struct Lifting {
    operations: Vec<Operation>,
    directions: usize,
    zero: Node,
    one: Node,
}

/// ∂x̃/∂x row by row: prepared constants and the step over dual numbers with a direction a state.
pub(super) fn jacobian_plan(field: &Field, step: &StepPlan) -> Plan {
    let step = step.for_any_step();
    let n = field.dimension();
    let mut lifting = Lifting::new(n);
    let constants = lifting.lift(&step.constants, &[], field, false);
    let kernel = lifting.lift(&step.kernel, &constants, field, true);
    let (numerators, reciprocals) = kernel.split_at(n);
    let mut outputs = Vec::with_capacity(n * n);
    for (i, (numerator, reciprocal)) in numerators.iter().zip(&step.reciprocals).enumerate() {
        let increment = match reciprocal {
            Some(index) => lifting.product(numerator, &reciprocals[*index]),
            None => numerator.clone(),
        };
        for (j, slope) in increment.gradient.into_iter().enumerate() {
            let one = lifting.one;
            outputs.push(if i == j { lifting.push(Operation::Add(one, slope)) } else { slope });
        }
    }
    Plan::together([&Plan { operations: lifting.operations, outputs }])
}

impl Lifting {
    fn new(directions: usize) -> Self {
        let operations = vec![Operation::Constant(Rational::zero()), Operation::Constant(Rational::one())];
        Lifting { operations, directions, zero: Node(0), one: Node(1) }
    }

    fn push(&mut self, operation: Operation) -> Node {
        self.operations.push(operation);
        Node(self.operations.len() - 1)
    }

    /// A number that depends on no direction.
    fn fixed(&self, value: Node) -> DualNode {
        DualNode { value, gradient: vec![self.zero; self.directions] }
    }

    /// The results of a plan; `is_kernel` where its quotients are computed by one reciprocal.
    fn lift(&mut self, plan: &Plan, prepared: &[DualNode], field: &Field, is_kernel: bool) -> Vec<DualNode> {
        let mut lifted: Vec<DualNode> = Vec::with_capacity(plan.operations.len());
        for operation in &plan.operations {
            let of = |node: Node| lifted[node.0].clone();
            let dual = match *operation {
                Operation::Input(variable) => self.input(field, variable),
                Operation::Prepared(index) => prepared[index].clone(),
                Operation::Constant(_) => {
                    let value = self.push(operation.clone());
                    self.fixed(value)
                }
                Operation::Negate(a) => self.parts(&of(a), Operation::Negate),
                Operation::Add(a, b) => self.pairs(&of(a), &of(b), Operation::Add),
                Operation::Subtract(a, b) => self.pairs(&of(a), &of(b), Operation::Subtract),
                Operation::Multiply(a, b) => self.product(&of(a), &of(b)),
                Operation::Divide(a, b) => self.quotient(&of(a), &of(b), is_kernel),
                Operation::MultiplyAdd(a, b, c) => {
                    let product = self.product(&of(a), &of(b));
                    self.pairs(&product, &of(c), Operation::Add)
                }
                Operation::MultiplySubtract(a, b, c) => {
                    let product = self.product(&of(a), &of(b));
                    self.pairs(&product, &of(c), Operation::Subtract)
                }
                Operation::SubtractProduct(a, b, c) => {
                    let product = self.product(&of(b), &of(c));
                    self.pairs(&of(a), &product, Operation::Subtract)
                }
            };
            lifted.push(dual);
        }
        plan.outputs.iter().map(|output| lifted[output.0].clone()).collect()
    }

    fn input(&mut self, field: &Field, variable: Variable) -> DualNode {
        let value = self.push(Operation::Input(variable));
        let mut dual = self.fixed(value);
        if let Symbol::State(i) = field.symbols.symbol(variable) {
            dual.gradient[i] = self.one;
        }
        dual
    }

    fn parts(&mut self, a: &DualNode, operation: impl Fn(Node) -> Operation) -> DualNode {
        let value = self.push(operation(a.value));
        DualNode { value, gradient: a.gradient.iter().map(|&slope| self.push(operation(slope))).collect() }
    }

    fn pairs(&mut self, a: &DualNode, b: &DualNode, operation: impl Fn(Node, Node) -> Operation) -> DualNode {
        let value = self.push(operation(a.value, b.value));
        let slopes = a.gradient.iter().zip(&b.gradient);
        DualNode { value, gradient: slopes.map(|(&a, &b)| self.push(operation(a, b))).collect() }
    }

    /// (uv)′ = u′v + uv′
    fn product(&mut self, u: &DualNode, v: &DualNode) -> DualNode {
        let value = self.push(Operation::Multiply(u.value, v.value));
        let slopes = u.gradient.iter().zip(&v.gradient).map(|(&du, &dv)| {
            let left = self.push(Operation::Multiply(du, v.value));
            let right = self.push(Operation::Multiply(u.value, dv));
            self.push(Operation::Add(left, right))
        });
        let gradient = slopes.collect();
        DualNode { value, gradient }
    }

    /// (u/v)′ = (u′ − (u/v)v′)/v
    fn quotient(&mut self, u: &DualNode, v: &DualNode, by_reciprocal: bool) -> DualNode {
        let value = self.push(Operation::Divide(u.value, v.value));
        let reciprocal = by_reciprocal.then(|| self.push(Operation::Divide(self.one, v.value)));
        let slopes = u.gradient.iter().zip(&v.gradient).map(|(&du, &dv)| {
            let moved = self.push(Operation::Multiply(value, dv));
            let above = self.push(Operation::Subtract(du, moved));
            self.push(match reciprocal {
                Some(reciprocal) => Operation::Multiply(above, reciprocal),
                None => Operation::Divide(above, v.value),
            })
        });
        let gradient = slopes.collect();
        DualNode { value, gradient }
    }
}
