//! The operations that plans are made of.

use kahan_syntax::rational::Rational;

use crate::arithmetic::Arithmetic;
use crate::poly::Variable;

use super::Node;

/// One operation of a plan; its operands are earlier operations.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// A state, a parameter or ε.
    Input(Variable),
    /// An exact constant.
    Constant(Rational),
    /// a + b
    Add(Node, Node),
    /// a − b
    Subtract(Node, Node),
    /// a · b
    Multiply(Node, Node),
    /// a / b
    Divide(Node, Node),
    /// −a
    Negate(Node),
    /// a · b + c, to be rounded once where the scalar can
    MultiplyAdd(Node, Node, Node),
    /// a · b − c, likewise
    MultiplySubtract(Node, Node, Node),
    /// a − b · c, likewise
    SubtractProduct(Node, Node, Node),
    /// The prepared constant with this index, in the kernel of a [`StepPlan`](super::StepPlan).
    Prepared(usize),
}

impl Operation {
    /// The operands, at most three, in order.
    pub fn operands(&self) -> impl Iterator<Item = Node> + use<> {
        let (nodes, count) = match *self {
            Operation::Input(_) | Operation::Constant(_) | Operation::Prepared(_) => ([Node(0); 3], 0),
            Operation::Negate(a) => ([a; 3], 1),
            Operation::Add(a, b)
            | Operation::Subtract(a, b)
            | Operation::Multiply(a, b)
            | Operation::Divide(a, b) => ([a, b, b], 2),
            Operation::MultiplyAdd(a, b, c)
            | Operation::MultiplySubtract(a, b, c)
            | Operation::SubtractProduct(a, b, c) => ([a, b, c], 3),
        };
        Operands { nodes, next: 0, count }
    }

    /// The same operation on other operands.
    #[must_use]
    pub fn with_operands(&self, mut rename: impl FnMut(Node) -> Node) -> Self {
        self.renamed(&mut rename)
    }

    fn renamed(&self, rename: &mut dyn FnMut(Node) -> Node) -> Self {
        let mut renamed = self.clone();
        match &mut renamed {
            Operation::Input(_) | Operation::Constant(_) | Operation::Prepared(_) => {}
            Operation::Negate(a) => *a = rename(*a),
            Operation::Add(a, b)
            | Operation::Subtract(a, b)
            | Operation::Multiply(a, b)
            | Operation::Divide(a, b) => (*a, *b) = (rename(*a), rename(*b)),
            Operation::MultiplyAdd(a, b, c)
            | Operation::MultiplySubtract(a, b, c)
            | Operation::SubtractProduct(a, b, c) => (*a, *b, *c) = (rename(*a), rename(*b), rename(*c)),
        }
        renamed
    }

    /// The value of the operation from the `values` of all operations before it; `None` where it,
    /// or one of its operands, has none, and for an input. A multiply-add of the machine's floats
    /// is a multiplication and an addition here: those that fuse are the generated code's business.
    #[inline(always)]
    pub fn compute<A: Arithmetic>(&self, arithmetic: &A, values: &[Option<A::Value>]) -> Option<A::Value> {
        let value = |node: Node| values[node.0].as_ref();
        match *self {
            Operation::Input(_) | Operation::Prepared(_) => None,
            Operation::Constant(ref constant) => arithmetic.constant(constant),
            Operation::Negate(a) => Some(arithmetic.negate(value(a)?)),
            Operation::Add(a, b) => Some(arithmetic.add(value(a)?, value(b)?)),
            Operation::Subtract(a, b) => Some(arithmetic.subtract(value(a)?, value(b)?)),
            Operation::Multiply(a, b) => Some(arithmetic.multiply(value(a)?, value(b)?)),
            Operation::Divide(a, b) => arithmetic.divide(value(a)?, value(b)?),
            Operation::MultiplyAdd(a, b, c) => Some(arithmetic.multiply_add(value(a)?, value(b)?, value(c)?)),
            Operation::MultiplySubtract(a, b, c) => {
                Some(arithmetic.multiply_subtract(value(a)?, value(b)?, value(c)?))
            }
            Operation::SubtractProduct(a, b, c) => {
                Some(arithmetic.subtract_product(value(a)?, value(b)?, value(c)?))
            }
        }
    }
}

/// The operands of one operation. All passes ask for them, and adapters of the standard library
/// would be a dozen calls for each where nothing is optimised.
struct Operands {
    nodes: [Node; 3],
    next: usize,
    count: usize,
}

impl Iterator for Operands {
    type Item = Node;

    fn next(&mut self) -> Option<Node> {
        if self.next == self.count {
            return None;
        }
        let node = self.nodes[self.next];
        self.next += 1;
        Some(node)
    }
}
