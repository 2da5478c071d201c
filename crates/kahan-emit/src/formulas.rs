//! Emits plans as tables of operations in postfix order.
//!
//! ```text
//! { use __kahan::Postfix::*; &[State(0), State(1), Multiply, Done, State(0), Negate, Done] }
//! ```
//!
//! An operation is repeated for each of its uses.

use kahan_algebra::plan::{Input, Node, Operation, Plan};
use kahan_algebra::symbols::{Symbol, Symbols};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::number::emit_exact;

pub(super) fn emit_formulas(plan: &Plan, symbols: &Symbols) -> TokenStream {
    let mut writer = PostfixWriter { plan, symbols, depths: depths(plan), steps: TokenStream::new() };
    for output in &plan.outputs {
        writer.node(*output);
        writer.steps.extend(quote!(Done,));
    }
    let steps = writer.steps;
    quote! { { use __kahan::Postfix::*; &[#steps] } }
}

/// Returns the stack depth of an operation, from the depths a and b of its operands.
fn combined_depth(a: usize, b: usize) -> usize {
    if a == b { a + 1 } else { a.max(b) }
}

/// Returns the stack depth that each operation needs.
fn depths(plan: &Plan) -> Vec<usize> {
    let mut depths: Vec<usize> = Vec::with_capacity(plan.operations.len());
    for operation in &plan.operations {
        let of = |node: Node| depths[node.0];
        depths.push(match *operation {
            Operation::MultiplyAdd(a, b, c)
            | Operation::MultiplySubtract(a, b, c)
            | Operation::SubtractProduct(c, a, b) => combined_depth(combined_depth(of(a), of(b)), of(c)),
            _ => {
                let mut operands = operation.operands();
                match (operands.next(), operands.next()) {
                    (Some(a), Some(b)) => combined_depth(of(a), of(b)),
                    (Some(a), None) => of(a),
                    _ => 1,
                }
            }
        });
    }
    depths
}

struct PostfixWriter<'a> {
    plan: &'a Plan,
    symbols: &'a Symbols,
    depths: Vec<usize>,
    steps: TokenStream,
}

impl PostfixWriter<'_> {
    fn node(&mut self, node: Node) {
        let step = match self.plan.operations[node.0] {
            Operation::Input(Input::Variable(variable)) => {
                let (of, place) = match self.symbols.symbol(variable) {
                    Symbol::State(k) => (quote!(State), k),
                    Symbol::Parameter(k) => (quote!(Parameter), k),
                    // If coefficients depend on ε, then ε has the index after the last parameter.
                    Symbol::Epsilon => (quote!(Parameter), self.symbols.parameters.len()),
                    Symbol::SecondState(_) => unreachable!("a field has no such variable"),
                };
                let place = Literal::usize_unsuffixed(place);
                quote!(#of(#place))
            }
            Operation::Constant(ref value) => {
                let value = emit_exact(value);
                quote!(Number(#value))
            }
            Operation::Input(Input::Prepared(_)) => unreachable!("formulas of a field prepare nothing"),
            Operation::Negate(a) => {
                self.node(a);
                quote!(Negate)
            }
            Operation::Add(a, b) => self.binary(PostfixOperand::Of(a), PostfixOperand::Of(b), ["Add"; 2]),
            Operation::Subtract(a, b) => {
                self.binary(PostfixOperand::Of(a), PostfixOperand::Of(b), ["Subtract", "SubtractFrom"])
            }
            Operation::Multiply(a, b) => {
                self.binary(PostfixOperand::Of(a), PostfixOperand::Of(b), ["Multiply"; 2])
            }
            Operation::Divide(a, b) => {
                self.binary(PostfixOperand::Of(a), PostfixOperand::Of(b), ["Divide", "DivideInto"])
            }
            Operation::MultiplyAdd(a, b, c) => {
                self.binary(PostfixOperand::Product(a, b), PostfixOperand::Of(c), ["Add"; 2])
            }
            Operation::MultiplySubtract(a, b, c) => self.binary(
                PostfixOperand::Product(a, b),
                PostfixOperand::Of(c),
                ["Subtract", "SubtractFrom"],
            ),
            Operation::SubtractProduct(a, b, c) => self.binary(
                PostfixOperand::Of(a),
                PostfixOperand::Product(b, c),
                ["Subtract", "SubtractFrom"],
            ),
            Operation::Call(ref function, ..) => match *function {},
        };
        self.steps.extend(quote!(#step,));
    }

    /// Writes both operands, and begins with the one that needs more stack. Returns `names[1]` if
    /// this exchanges them, and `names[0]` otherwise.
    fn binary(&mut self, a: PostfixOperand, b: PostfixOperand, names: [&str; 2]) -> TokenStream {
        let is_exchanged = self.depth(b) > self.depth(a);
        let [first, second] = if is_exchanged { [b, a] } else { [a, b] };
        self.part(first);
        self.part(second);
        let name = quote::format_ident!("{}", names[usize::from(is_exchanged)]);
        quote!(#name)
    }

    fn depth(&self, part: PostfixOperand) -> usize {
        match part {
            PostfixOperand::Of(node) => self.depths[node.0],
            PostfixOperand::Product(a, b) => combined_depth(self.depths[a.0], self.depths[b.0]),
        }
    }

    fn part(&mut self, part: PostfixOperand) {
        match part {
            PostfixOperand::Of(node) => self.node(node),
            PostfixOperand::Product(a, b) => {
                let product = self.binary(PostfixOperand::Of(a), PostfixOperand::Of(b), ["Multiply"; 2]);
                self.steps.extend(quote!(#product,));
            }
        }
    }
}

/// An operand: a node of the plan, or the product inside a fused operation.
#[derive(Clone, Copy)]
enum PostfixOperand {
    Of(Node),
    Product(Node, Node),
}
