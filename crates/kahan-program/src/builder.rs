//! Builds programs without repeated operations, simplified by rules that hold in every field.

use alloc::vec::Vec;
use core::convert::Infallible;
use core::hash::Hash;

use crate::operation::{Function, Node, Operation};
use crate::{Numbered, Program};

/// A type of constants that a [`Builder`] can simplify.
pub trait ExactConstant: Clone + Eq + Hash {
    /// Returns the number 1.
    fn one() -> Self;
    /// Returns whether the constant equals the integer n.
    fn is(&self, n: i64) -> bool;
    /// Returns whether the constant is less than 0.
    fn is_negative(&self) -> bool;
    /// Returns the negative of the constant.
    #[must_use]
    fn negated(&self) -> Self;
    /// Returns the constant divided by `divisor`; `None` if the quotient cannot be represented.
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
    /// Returns the program of the operations that these outputs need.
    #[must_use]
    pub fn finish(&self, outputs: &[Node]) -> Program<Vec<Operation<I, C, F>>> {
        Program::of_results(&self.operations, outputs)
    }

    /// Returns all operations of the builder.
    #[must_use]
    pub fn operations(&self) -> &[Operation<I, C, F>] {
        &self.operations
    }

    /// Removes all operations after the first `length` ones.
    pub fn truncate(&mut self, length: usize) {
        self.operations.truncate(length);
    }

    /// Returns the node of an operation. A new operation is added without simplification.
    ///
    /// # Panics
    /// If an operand is not an operation of this builder.
    pub fn push(&mut self, operation: Operation<I, C, F>) -> Node {
        Node(self.operations.number(operation))
    }

    /// Returns the node of an input.
    pub fn input(&mut self, input: I) -> Node {
        self.push(Operation::Input(input))
    }

    /// Returns whether a · b is already an operation.
    #[must_use]
    pub fn has_product(&self, a: Node, b: Node) -> bool {
        self.operations.find(&Operation::Multiply(a.min(b), a.max(b))).is_some()
    }

    /// Returns the node of −a. Unlike [`negate`](Self::negate), does not turn −(x − y) into y − x.
    pub fn changed_sign(&mut self, a: Node) -> Node {
        match *self.operation(a) {
            Operation::Negate(inner) => inner,
            _ => self.push(Operation::Negate(a)),
        }
    }

    /// Adds all operations of another program, and returns the node of each.
    pub fn include_all(&mut self, operations: &[Operation<I, C, F>]) -> Vec<Node> {
        let mut renamed: Vec<Node> = Vec::with_capacity(operations.len());
        for operation in operations {
            let node = self.push(operation.with_operands(|node| renamed[node.0]));
            renamed.push(node);
        }
        renamed
    }

    /// Adds the operations of another program, and returns the nodes of its outputs.
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

    /// Returns the constant |a| if the node a is a constant or the negation of one.
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

    /// Returns whether a node is the constant 0.
    #[must_use]
    pub fn is_zero(&self, node: Node) -> bool {
        self.is_constant(node, 0)
    }

    /// Returns the node of a constant. A negative constant becomes the negation of a positive one.
    pub fn constant(&mut self, value: &C) -> Node {
        if value.is_negative() {
            let size = self.push(Operation::Constant(value.negated()));
            return self.push(Operation::Negate(size));
        }
        self.push(Operation::Constant(value.clone()))
    }

    /// Returns the node of −a.
    pub fn negate(&mut self, a: Node) -> Node {
        match *self.operation(a) {
            Operation::Negate(inner) => inner,
            Operation::Subtract(x, y) => self.push(Operation::Subtract(y, x)),
            _ if self.is_constant(a, 0) => a,
            _ => self.push(Operation::Negate(a)),
        }
    }

    /// Returns the node of a + b.
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

    /// Returns the node of a − b.
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

    /// Returns the node of a · b.
    pub fn multiply(&mut self, a: Node, b: Node) -> Node {
        if self.is_constant(a, 0) || self.is_constant(b, 1) {
            return a;
        }
        if self.is_constant(b, 0) || self.is_constant(a, 1) {
            return b;
        }
        // The smaller node becomes the first operand, so a·b and b·a are one operation.
        self.with_sign_outside(a, b, Self::multiply)
            .unwrap_or_else(|| self.push(Operation::Multiply(a.min(b), a.max(b))))
    }

    /// Calls `join` with a and b without their minus signs, and negates the result if exactly one
    /// had a minus sign. Returns `None` if neither has one.
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

    /// Returns the node of a / b. A division by the constant 0 fails only when the program runs.
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

    /// Returns the node of a^n, where n is `exponent`, by repeated squaring; a^0 is 1.
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
