//! The operations of a straight-line program, and their operands.

use core::convert::Infallible;

/// The result of an operation, identified by the operation's index in the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Node(pub usize);

/// An operation on the results of earlier operations.
///
/// `I` is the type of inputs, `C` that of constants, and `F` that of functions to call. A program
/// without functions has `F` = [`Infallible`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation<I, C, F = Infallible> {
    /// An input of the program.
    Input(I),
    /// A constant embedded in the program.
    Constant(C),
    /// The sum a + b.
    Add(Node, Node),
    /// The difference a − b.
    Subtract(Node, Node),
    /// The product a · b.
    Multiply(Node, Node),
    /// The quotient a / b.
    Divide(Node, Node),
    /// The negation −a.
    Negate(Node),
    /// The value a · b + c, rounded once if the arithmetic can do so.
    MultiplyAdd(Node, Node, Node),
    /// The value a · b − c, rounded once if the arithmetic can do so.
    MultiplySubtract(Node, Node, Node),
    /// The value a − b · c, rounded once if the arithmetic can do so.
    SubtractProduct(Node, Node, Node),
    /// The result f(a, b). If the function f has one argument, b = a.
    Call(F, Node, Node),
}

/// A double as a constant. Constants are compared by their bits, so 0 and −0 differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Float(u64);

impl Float {
    /// Creates a constant from a double.
    #[must_use]
    pub const fn of(value: f64) -> Self {
        Float(value.to_bits())
    }

    /// Returns the value of the constant.
    #[inline]
    #[must_use]
    pub const fn value(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// A type whose values are functions that operations can call.
pub trait Function {
    /// Returns the number of arguments, 1 or 2.
    fn arguments(&self) -> usize;
}

impl Function for Infallible {
    fn arguments(&self) -> usize {
        match *self {}
    }
}

impl<I, C, F: Function> Operation<I, C, F> {
    /// Returns the operands in order, at most three.
    pub fn operands(&self) -> impl Iterator<Item = Node> + use<I, C, F> {
        let (nodes, count) = match *self {
            Operation::Input(_) | Operation::Constant(_) => ([Node(0); 3], 0),
            Operation::Negate(a) => ([a; 3], 1),
            Operation::Add(a, b)
            | Operation::Subtract(a, b)
            | Operation::Multiply(a, b)
            | Operation::Divide(a, b) => ([a, b, b], 2),
            Operation::MultiplyAdd(a, b, c)
            | Operation::MultiplySubtract(a, b, c)
            | Operation::SubtractProduct(a, b, c) => ([a, b, c], 3),
            Operation::Call(ref function, a, b) => ([a, b, b], function.arguments()),
        };
        Operands { nodes, next: 0, count }
    }
}

impl<I, C, F> Operation<I, C, F> {
    /// Renames the operands of an arithmetic operation by `rename`, for a program with other types
    /// of inputs, constants and functions. Returns `None` for inputs, constants and calls.
    pub fn computed<J, D, G>(&self, mut rename: impl FnMut(Node) -> Node) -> Option<Operation<J, D, G>> {
        Some(match *self {
            Operation::Input(_) | Operation::Constant(_) | Operation::Call(..) => return None,
            Operation::Add(a, b) => Operation::Add(rename(a), rename(b)),
            Operation::Subtract(a, b) => Operation::Subtract(rename(a), rename(b)),
            Operation::Multiply(a, b) => Operation::Multiply(rename(a), rename(b)),
            Operation::Divide(a, b) => Operation::Divide(rename(a), rename(b)),
            Operation::Negate(a) => Operation::Negate(rename(a)),
            Operation::MultiplyAdd(a, b, c) => Operation::MultiplyAdd(rename(a), rename(b), rename(c)),
            Operation::MultiplySubtract(a, b, c) => {
                Operation::MultiplySubtract(rename(a), rename(b), rename(c))
            }
            Operation::SubtractProduct(a, b, c) => {
                Operation::SubtractProduct(rename(a), rename(b), rename(c))
            }
        })
    }

    /// Returns whether the operation is an input or a constant.
    #[inline]
    #[must_use]
    pub fn is_given(&self) -> bool {
        matches!(self, Operation::Input(_) | Operation::Constant(_))
    }
}

impl<I: Clone, C: Clone, F: Clone> Operation<I, C, F> {
    /// Returns the operation with operands renamed by `rename`.
    #[must_use]
    pub fn with_operands(&self, mut rename: impl FnMut(Node) -> Node) -> Self {
        self.renamed(&mut rename)
    }

    fn renamed(&self, rename: &mut dyn FnMut(Node) -> Node) -> Self {
        match self {
            Operation::Call(function, a, b) => Operation::Call(function.clone(), rename(*a), rename(*b)),
            _ => self.computed(rename).unwrap_or_else(|| self.clone()),
        }
    }
}

/// Iterates over the operands of an operation. In unoptimised builds this is faster than iterator
/// adapters.
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
