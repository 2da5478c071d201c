//! Writing programs: every operation once, with the obvious simplifications.
//!
//! Simplifications are exact identities only (0 + a, 1 · a, a − (−b), …), so a program computes
//! what was asked over any field.

use alloc::vec::Vec;
use core::convert::Infallible;
use core::hash::Hash;

use crate::operation::{Function, Node, Operation};
use crate::{Numbered, Program};

/// Constants that a [`Builder`] simplifies with.
pub trait ExactConstant: Clone + Eq + Hash {
    /// The number 1.
    fn one() -> Self;
    /// Whether this is the integer n.
    fn is(&self, n: i64) -> bool;
    /// Whether this is less than 0.
    fn is_negative(&self) -> bool;
    /// −c
    #[must_use]
    fn negated(&self) -> Self;
    /// c / d; `None` where it is no constant, such as for d = 0.
    fn quotient(&self, divisor: &Self) -> Option<Self>;
}

/// A program under construction.
#[derive(Clone, Debug)]
pub struct Builder<I, C, F = Infallible> {
    operations: Numbered<Operation<I, C, F>>,
}

impl<I, C, F> Default for Builder<I, C, F> {
    fn default() -> Self {
        Builder { operations: Numbered::default() }
    }
}

impl<I, C, F> Builder<I, C, F>
where
    I: Clone + Eq + Hash,
    C: Clone + Eq + Hash,
    F: Function + Clone + Eq + Hash,
{
    /// Returns the program with these outputs; operations that no output needs are dropped.
    #[must_use]
    pub fn finish(&self, outputs: &[Node]) -> Program<Vec<Operation<I, C, F>>> {
        Program::of_results(&self.operations, outputs)
    }

    /// Returns the operations so far.
    #[must_use]
    pub fn operations(&self) -> &[Operation<I, C, F>] {
        &self.operations
    }

    /// Forgets all operations but the first `length`.
    pub fn truncate(&mut self, length: usize) {
        self.operations.truncate(length);
    }

    /// Returns the number of this very operation, without simplification; an operation that is
    /// there already keeps its number.
    ///
    /// # Panics
    /// If an operand is no operation of this builder.
    pub fn push(&mut self, operation: Operation<I, C, F>) -> Node {
        Node(self.operations.number(operation))
    }

    /// Returns an input.
    pub fn input(&mut self, input: I) -> Node {
        self.push(Operation::Input(input))
    }

    /// Whether the product of two operations is an operation already.
    #[must_use]
    pub fn has_product(&self, a: Node, b: Node) -> bool {
        self.operations.find(&Operation::Multiply(a.min(b), a.max(b))).is_some()
    }

    /// Returns −a as a change of sign, for a whose value is needed, too.
    pub fn changed_sign(&mut self, a: Node) -> Node {
        match *self.operation(a) {
            Operation::Negate(inner) => inner,
            _ => self.push(Operation::Negate(a)),
        }
    }

    /// Adds all operations of another program, and returns the number of each here.
    pub fn include_all(&mut self, operations: &[Operation<I, C, F>]) -> Vec<Node> {
        let mut renamed: Vec<Node> = Vec::with_capacity(operations.len());
        for operation in operations {
            let node = self.push(operation.with_operands(|node| renamed[node.0]));
            renamed.push(node);
        }
        renamed
    }

    /// Adds the operations of another program, and returns its outputs here.
    pub fn include(&mut self, program: &Program<Vec<Operation<I, C, F>>>) -> Vec<Node> {
        let renamed = self.include_all(&program.operations);
        program.outputs.iter().map(|output| renamed[output.0]).collect()
    }

    fn operation(&self, node: Node) -> &Operation<I, C, F> {
        &self.operations[node.0]
    }

    fn value(&self, node: Node) -> Option<&C> {
        match self.operation(node) {
            Operation::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// Returns |a| of a constant.
    #[must_use]
    pub fn constant_size(&self, a: Node) -> Option<&C> {
        match *self.operation(a) {
            Operation::Negate(size) => self.value(size),
            _ => self.value(a),
        }
    }
}

impl<I, C, F> Builder<I, C, F>
where
    I: Clone + Eq + Hash,
    C: ExactConstant,
    F: Function + Clone + Eq + Hash,
{
    fn is_constant(&self, node: Node, n: i64) -> bool {
        self.value(node).is_some_and(|constant| constant.is(n))
    }

    /// Whether a node is the constant 0.
    #[must_use]
    pub fn is_zero(&self, node: Node) -> bool {
        self.is_constant(node, 0)
    }

    /// Returns a constant; a negative one is the negation of its size, so that signs can move.
    pub fn constant(&mut self, value: &C) -> Node {
        if value.is_negative() {
            let size = self.push(Operation::Constant(value.negated()));
            return self.push(Operation::Negate(size));
        }
        self.push(Operation::Constant(value.clone()))
    }

    /// −a
    pub fn negate(&mut self, a: Node) -> Node {
        match *self.operation(a) {
            Operation::Negate(inner) => inner,
            Operation::Subtract(x, y) => self.push(Operation::Subtract(y, x)),
            _ if self.is_constant(a, 0) => a,
            _ => self.push(Operation::Negate(a)),
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
        match (self.operation(a), self.operation(b)) {
            (_, &Operation::Negate(b)) => self.subtract(a, b),
            (&Operation::Negate(a), _) => self.subtract(b, a),
            _ => self.push(Operation::Add(a, b)),
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
            _ => self.push(Operation::Subtract(a, b)),
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
            .unwrap_or_else(|| self.push(Operation::Multiply(a.min(b), a.max(b))))
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
        let quotient = self.value(a).zip(self.value(b)).and_then(|(a, b)| a.quotient(b));
        if let Some(quotient) = quotient {
            return self.constant(&quotient);
        }
        self.with_sign_outside(a, b, Self::divide).unwrap_or_else(|| self.push(Operation::Divide(a, b)))
    }

    /// a^n by repeated squaring; a^0 is 1.
    pub fn power(&mut self, a: Node, exponent: u32) -> Node {
        match exponent {
            0 => self.constant(&C::one()),
            1 => a,
            _ => {
                let half = self.power(a, exponent / 2);
                let square = self.multiply(half, half);
                if exponent.is_multiple_of(2) { square } else { self.multiply(square, a) }
            }
        }
    }
}
