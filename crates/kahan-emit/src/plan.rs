//! Emits a plan as Rust. A value used more than once, or nested too deeply, gets a `let`, and so
//! does a quotient in a kernel.
//!
//! ```text
//! let __t_eps_x = __e_eps.get() * __s_x.clone();
//! let __reciprocal_1 = (__kahan::integer::<T>(1) + __t_eps_x.clone()).reciprocal()?;
//! ```
//!
//! Values with a `let` and states of kernels are cloned at each use except the last. Other inputs,
//! such as prepared constants, are always cloned. The `let`s keep the order of the plan.

use kahan_algebra::derived::ValueNames;
use kahan_algebra::plan::{Input, Node, Operation, Plan};
use kahan_algebra::symbols::Symbols;
use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};

use super::input_bindings::binding;
use super::names;
use super::number::emit_constant;

/// Values nested deeper than this get a `let`: deep expressions overflow the stack of rustc.
const MAX_NESTING: usize = 24;

/// The Rust code of a plan. Results must be evaluated in order, as the last use moves a binding.
pub(super) struct Emitted {
    pub(super) bindings: TokenStream,
    pub(super) results: Vec<TokenStream>,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Precedence {
    Sum,
    Product,
    Atom,
}

struct Expression {
    tokens: TokenStream,
    level: Precedence,
}

impl Expression {
    fn atom(tokens: TokenStream) -> Self {
        Expression { tokens, level: Precedence::Atom }
    }

    /// Returns the tokens, in parentheses if their precedence is lower than `level`.
    fn grouped(self, level: Precedence) -> TokenStream {
        if self.level >= level { self.tokens } else { parenthesised(self.tokens) }
    }
}

/// Puts tokens into parentheses. Unlike `quote!`, this does not copy the tokens.
fn parenthesised(tokens: TokenStream) -> TokenStream {
    TokenTree::from(Group::new(Delimiter::Parenthesis, tokens)).into()
}

fn infix(mut left: TokenStream, operator: char, right: TokenStream) -> TokenStream {
    left.extend([TokenTree::from(Punct::new(operator, Spacing::Alone))]);
    left.extend([right]);
    left
}

fn call(mut value: TokenStream, method: &str, arguments: TokenStream) -> TokenStream {
    let name = Ident::new(method, Span::call_site());
    let dot = Punct::new('.', Spacing::Alone);
    let arguments = Group::new(Delimiter::Parenthesis, arguments);
    value.extend([TokenTree::from(dot), TokenTree::from(name), TokenTree::from(arguments)]);
    value
}

struct Emitter<'a> {
    plan: &'a Plan,
    symbols: &'a Symbols,
    scalar: &'a Ident,
    /// The names of the constants that a kernel reads; `None` outside kernels. A kernel is code
    /// that returns `None` at a pole.
    constants: Option<&'a [String]>,
    /// Whether the value of each `let` passes through `fenced`, which keeps rustc from vectorising.
    has_fences: bool,
    /// For each value, the number of uses that are not yet written.
    uses: Vec<usize>,
    /// For each value, the nesting depth of its expression. An operand with a `let` adds no depth.
    depths: Vec<usize>,
    lets: Vec<Option<Ident>>,
    names: ValueNames,
    bindings: TokenStream,
}

/// Emits a plan whose inputs were bound by [`emit_inputs`](super::input_bindings::emit_inputs).
pub(super) fn emit_plan(plan: &Plan, symbols: &Symbols, scalar: &Ident) -> Emitted {
    Emitter::new(plan, symbols, scalar, None).run()
}

/// Emits the kernel of a step: code that reads `constants` and returns `None` at a pole.
pub(super) fn emit_kernel(
    kernel: &Plan,
    symbols: &Symbols,
    scalar: &Ident,
    constants: &[String],
    has_fences: bool,
) -> Emitted {
    Emitter { has_fences, ..Emitter::new(kernel, symbols, scalar, Some(constants)) }.run()
}

impl<'a> Emitter<'a> {
    fn new(plan: &'a Plan, symbols: &'a Symbols, scalar: &'a Ident, constants: Option<&'a [String]>) -> Self {
        let mut emitter = Emitter {
            plan,
            symbols,
            scalar,
            constants,
            has_fences: false,
            uses: vec![0; plan.operations.len()],
            depths: Vec::with_capacity(plan.operations.len()),
            lets: vec![None; plan.operations.len()],
            names: ValueNames::of(plan, symbols, constants.unwrap_or_default()),
            bindings: TokenStream::new(),
        };
        let operands = plan.operations.iter().flat_map(|operation| emitter.operands(operation));
        let used: Vec<Node> = operands.chain(plan.outputs.iter().copied()).collect();
        for node in used {
            emitter.uses[node.0] += 1;
        }
        emitter
    }

    fn run(mut self) -> Emitted {
        for index in 0..self.plan.operations.len() {
            self.step(index);
        }
        let outputs = self.plan.outputs.iter();
        let results = outputs.map(|output| self.operand(*output).tokens).collect();
        Emitted { bindings: self.bindings, results }
    }

    /// Returns the operands in the Rust code of `operation`. For a reciprocal 1/b this is only b.
    fn operands(&self, operation: &Operation) -> impl Iterator<Item = Node> + use<> {
        let written = usize::from(self.reciprocal_of(operation).is_some());
        operation.operands().skip(written)
    }

    fn reciprocal_of(&self, operation: &Operation) -> Option<Node> {
        match *operation {
            Operation::Divide(a, b) if self.constants.is_some() => {
                let is_one =
                    matches!(&self.plan.operations[a.0], Operation::Constant(one) if one.as_i64() == Some(1));
                is_one.then_some(b)
            }
            _ => None,
        }
    }

    fn step(&mut self, index: usize) {
        let operation = &self.plan.operations[index];
        let nested = self.operands(operation).filter(|operand| self.lets[operand.0].is_none());
        let depth = nested.map(|operand| self.depths[operand.0] + 1).max().unwrap_or(0);
        self.depths.push(depth);
        if let (Operation::Input(Input::Variable(variable)), Some(_)) = (operation, self.constants) {
            self.lets[index] = Some(binding(self.symbols, *variable));
            return;
        }
        let is_borrowed = matches!(operation, Operation::Input(_));
        let is_quotient = self.constants.is_some() && matches!(operation, Operation::Divide(..));
        if is_borrowed || self.uses[index] == 0 {
            return;
        }
        if self.uses[index] > 1 || depth > MAX_NESTING || is_quotient {
            let value = self.operation(index).tokens;
            let name = names::binding(&mut self.names, Node(index), operation);
            let value = if self.has_fences { quote!(__kahan::fenced(#value)) } else { value };
            self.bindings.extend(quote! { let #name = #value; });
            self.lets[index] = Some(name);
        }
    }

    fn operand(&mut self, node: Node) -> Expression {
        let Some(name) = &self.lets[node.0] else { return self.operation(node.0) };
        self.uses[node.0] -= 1;
        Expression::atom(if self.uses[node.0] == 0 { quote!(#name) } else { quote!(#name.clone()) })
    }

    fn operation(&mut self, index: usize) -> Expression {
        let plan = self.plan;
        match plan.operations[index] {
            Operation::Input(Input::Variable(variable)) => {
                let name = binding(self.symbols, variable);
                Expression::atom(quote!(#name.clone()))
            }
            Operation::Input(Input::Prepared(constant)) => {
                let name = self.constants.and_then(|constants| constants.get(constant));
                let name = name.map(|name| format_ident!("__e_{name}"));
                Expression::atom(quote!(#name.get()))
            }
            Operation::Constant(ref value) => Expression::atom(emit_constant(value, self.scalar)),
            Operation::Negate(a) => {
                let a = self.operand(a).grouped(Precedence::Atom);
                Expression { tokens: quote!(-#a), level: Precedence::Sum }
            }
            Operation::Add(a, b) => self.binary(a, b, Precedence::Sum, '+'),
            Operation::Subtract(a, b) => self.binary(a, b, Precedence::Sum, '-'),
            Operation::Multiply(a, b) => self.binary(a, b, Precedence::Product, '*'),
            Operation::Divide(a, b) => self.quotient(&plan.operations[index], a, b),
            Operation::MultiplyAdd(a, b, c) => self.fused([a, b, c], "multiply_add"),
            Operation::MultiplySubtract(a, b, c) => self.fused([a, b, c], "multiply_subtract"),
            Operation::SubtractProduct(a, b, c) => self.fused([a, b, c], "subtract_product"),
            Operation::Call(ref function, ..) => match *function {},
        }
    }

    /// Writes a binary operation, with parentheses around operands of lower precedence.
    fn binary(&mut self, a: Node, b: Node, level: Precedence, operator: char) -> Expression {
        let tighter = if level == Precedence::Sum { Precedence::Product } else { Precedence::Atom };
        let (a, b) = (self.operand(a).grouped(level), self.operand(b).grouped(tighter));
        Expression { tokens: infix(a, operator, b), level }
    }

    fn fused(&mut self, [a, b, c]: [Node; 3], method: &str) -> Expression {
        let (a, b, c) = (self.operand(a).grouped(Precedence::Atom), self.operand(b), self.operand(c));
        Expression::atom(call(a, method, infix(b.tokens, ',', c.tokens)))
    }

    /// Writes `a / b`, or in a kernel `b.reciprocal()?` or `a.quotient(b)?`, which report a pole.
    fn quotient(&mut self, operation: &Operation, a: Node, b: Node) -> Expression {
        if self.constants.is_none() {
            return self.binary(a, b, Precedence::Product, '/');
        }
        if let Some(divisor) = self.reciprocal_of(operation) {
            let divisor = self.operand(divisor).grouped(Precedence::Atom);
            return Expression::atom(quote!(#divisor.reciprocal()?));
        }
        let (a, b) = (self.operand(a).grouped(Precedence::Atom), self.operand(b).tokens);
        Expression::atom(quote!(#a.quotient(#b)?))
    }
}
