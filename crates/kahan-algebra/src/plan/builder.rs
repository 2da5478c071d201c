//! Building plans: hash-consed operations with the obvious simplifications.
//!
//! Simplifications are exact identities only (0 + a, 1 · a, a − (−b), …), so a plan computes what
//! was asked over ℚ.

use kahan_syntax::rational::Rational;

use crate::numbered::Numbered;
use crate::poly::Variable;

use super::{Node, Operation, Plan};

/// A plan under construction.
#[derive(Clone, Debug, Default)]
pub struct PlanBuilder {
    operations: Numbered<Operation>,
    /// How many terms of polynomials were looked at to nest them.
    pub(super) looked_at: usize,
}

impl PlanBuilder {
    /// Closes the plan with these results; operations that no result needs are dropped.
    #[must_use]
    pub fn finish(&self, outputs: &[Node]) -> Plan {
        Plan::of_results(self.operations(), outputs)
    }

    /// Becomes the plan with these results, in the memory of its operations.
    #[must_use]
    pub fn into_plan(self, outputs: &[Node]) -> Plan {
        Plan::into_results(self.operations.into_items(), outputs)
    }

    /// A prepared constant.
    pub(super) fn prepared(&mut self, index: usize) -> Node {
        self.intern(Operation::Prepared(index))
    }

    /// The operations so far.
    pub(super) fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// Forgets all operations but the first `length`.
    pub(super) fn truncate(&mut self, length: usize) {
        self.operations.truncate(length);
    }

    /// −a as a change of sign, for a whose value is needed, too.
    pub(super) fn changed_sign(&mut self, a: Node) -> Node {
        match *self.operation(a) {
            Operation::Negate(inner) => inner,
            _ => self.intern(Operation::Negate(a)),
        }
    }

    /// Whether the product of two operations is an operation already.
    pub(super) fn has_product(&self, a: Node, b: Node) -> bool {
        self.operations.find(&Operation::Multiply(a.min(b), a.max(b))).is_some()
    }

    /// This very operation, without simplification; the same one as before, if it is an operation
    /// already.
    pub(super) fn intern(&mut self, operation: Operation) -> Node {
        Node(self.operations.number(operation))
    }

    fn operation(&self, node: Node) -> &Operation {
        &self.operations[node.0]
    }

    fn value(&self, node: Node) -> Option<&Rational> {
        match self.operation(node) {
            Operation::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// |a| of a constant.
    pub(crate) fn constant_size(&self, a: Node) -> Option<&Rational> {
        match *self.operation(a) {
            Operation::Negate(size) => self.value(size),
            _ => self.value(a),
        }
    }

    fn is_constant(&self, node: Node, value: i64) -> bool {
        self.value(node).is_some_and(|constant| constant.as_i64() == Some(value))
    }

    /// Whether a node is the constant 0.
    #[must_use]
    pub fn is_zero(&self, node: Node) -> bool {
        self.is_constant(node, 0)
    }

    /// A variable.
    pub fn input(&mut self, variable: Variable) -> Node {
        self.intern(Operation::Input(variable))
    }

    /// A constant; a negative one is the negation of its size, so that signs can move.
    pub fn constant(&mut self, value: &Rational) -> Node {
        if value.is_negative() {
            let size = self.intern(Operation::Constant(-value));
            return self.intern(Operation::Negate(size));
        }
        self.intern(Operation::Constant(value.clone()))
    }

    /// −a
    pub fn negate(&mut self, a: Node) -> Node {
        match *self.operation(a) {
            Operation::Negate(inner) => inner,
            Operation::Subtract(x, y) => self.intern(Operation::Subtract(y, x)),
            _ if self.is_constant(a, 0) => a,
            _ => self.intern(Operation::Negate(a)),
        }
    }

    /// a + b
    pub fn add(&mut self, a: Node, b: Node) -> Node {
        if self.is_constant(a, 0) {
            return b;
        }
        if self.is_constant(b, 0) {
            return a;
        }
        match (self.operation(a).clone(), self.operation(b).clone()) {
            (_, Operation::Negate(b)) => self.subtract(a, b),
            (Operation::Negate(a), _) => self.subtract(b, a),
            _ => self.intern(Operation::Add(a, b)),
        }
    }

    /// a − b
    pub fn subtract(&mut self, a: Node, b: Node) -> Node {
        if self.is_constant(b, 0) {
            return a;
        }
        if self.is_constant(a, 0) {
            return self.negate(b);
        }
        match *self.operation(b) {
            Operation::Negate(b) => self.add(a, b),
            _ => self.intern(Operation::Subtract(a, b)),
        }
    }

    /// a · b
    pub fn multiply(&mut self, a: Node, b: Node) -> Node {
        if self.is_constant(a, 0) || self.is_constant(b, 1) {
            return a;
        }
        if self.is_constant(b, 0) || self.is_constant(a, 1) {
            return b;
        }
        // One order for both orders: a·b and b·a are the same operation.
        self.with_sign_outside(a, b, Self::multiply)
            .unwrap_or_else(|| self.intern(Operation::Multiply(a.min(b), a.max(b))))
    }

    /// The product or quotient of two values of which one is a negation, the sign in front.
    fn with_sign_outside(
        &mut self,
        a: Node,
        b: Node,
        join: impl FnOnce(&mut Self, Node, Node) -> Node,
    ) -> Option<Node> {
        let size = |node: Node| match *self.operation(node) {
            Operation::Negate(inner) => Some(inner),
            _ => None,
        };
        let (own, other) = (size(a), size(b));
        own.or(other)?;
        let joined = join(self, own.unwrap_or(a), other.unwrap_or(b));
        Some(if own.is_some() != other.is_some() { self.negate(joined) } else { joined })
    }

    /// a / b; a zero constant b stays, as a quotient without a value.
    pub fn divide(&mut self, a: Node, b: Node) -> Node {
        if self.is_constant(b, 1) {
            return a;
        }
        let quotient = self.value(a).zip(self.value(b)).and_then(|(a, b)| a.checked_div(b));
        if let Some(quotient) = quotient {
            return self.constant(&quotient);
        }
        self.with_sign_outside(a, b, Self::divide).unwrap_or_else(|| self.intern(Operation::Divide(a, b)))
    }

    /// a^n by repeated squaring; a^0 is 1.
    pub fn power(&mut self, a: Node, exponent: u32) -> Node {
        match exponent {
            0 => self.constant(&Rational::one()),
            1 => a,
            _ => {
                let half = self.power(a, exponent / 2);
                let square = self.multiply(half, half);
                if exponent.is_multiple_of(2) { square } else { self.multiply(square, a) }
            }
        }
    }
}
