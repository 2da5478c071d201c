//! A plan as Rust: one `let` for each step that is used more than once, everything else nested where it is used.
//!
//! ```text
//! let __t_eps_x = __half_step.clone() * __s_x.clone();
//! let __sum_1 = __kahan::integer::<T>(1) + __t_eps_x.clone();
//! ```
//!
//! The order of operations is the plan's, whatever the nesting. Values are cloned where they are used: free for floats,
//! and little beside an operation for big rationals.

use std::collections::BTreeSet;

use kahan_algebra::plan::{Node, Operation, Plan};
use kahan_algebra::poly::Variable;
use kahan_algebra::symbols::{Symbol, Symbols};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::number::emit_constant;

/// Nested operations beyond this depth get a `let`, for readers and for rustc's stack.
const DEEPEST: usize = 24;

/// A plan's Rust: the bindings, and one expression a result.
pub(super) struct Emitted {
    pub(super) bindings: TokenStream,
    pub(super) results: Vec<TokenStream>,
}

/// How tightly an expression binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Sum,
    Product,
    Atom,
}

#[derive(Clone)]
struct Expression {
    tokens: TokenStream,
    level: Level,
    depth: usize,
}

struct Emitter<'a> {
    plan: &'a Plan,
    symbols: &'a Symbols,
    scalar: &'a Ident,
    uses: Vec<usize>,
    /// The expression of each step so far; for one with a `let`, its name.
    expressions: Vec<Option<Expression>>,
    names: Vec<Option<Ident>>,
    bindings: TokenStream,
    /// The product names given so far.
    products: BTreeSet<String>,
    counter: usize,
}

/// Emits a plan. Inputs are the bindings of [`emit_inputs`].
pub(super) fn emit_plan(plan: &Plan, symbols: &Symbols, scalar: &Ident) -> Emitted {
    let mut emitter = Emitter {
        plan,
        symbols,
        scalar,
        uses: plan.uses(),
        expressions: vec![None; plan.operations.len()],
        names: vec![None; plan.operations.len()],
        bindings: TokenStream::new(),
        products: BTreeSet::new(),
        counter: 0,
    };
    for index in 0..plan.operations.len() {
        emitter.step(index);
    }
    let results = plan.outputs.iter().map(|output| emitter.operand(*output).tokens).collect();
    Emitted { bindings: emitter.bindings, results }
}

impl Emitter<'_> {
    fn step(&mut self, index: usize) {
        let operation = &self.plan.operations[index];
        let expression = self.expression(operation);
        let is_input = matches!(operation, Operation::Input(_));
        if !is_input && (self.uses[index] > 1 || expression.depth > DEEPEST) {
            let name = self.name_of(Node(index));
            let tokens = expression.tokens;
            self.bindings.extend(quote! { let #name = #tokens; });
            self.names[index] = Some(name);
        } else {
            self.expressions[index] = Some(expression);
        }
    }

    fn expression(&self, operation: &Operation) -> Expression {
        let atom = |tokens| Expression { tokens, level: Level::Atom, depth: 0 };
        match *operation {
            Operation::Input(variable) => {
                let name = binding(self.symbols, variable);
                atom(quote!(#name.clone()))
            }
            Operation::Constant(ref value) => atom(emit_constant(value, self.scalar)),
            Operation::Negate(a) => {
                let a = self.operand(a);
                let inner = grouped(&a, Level::Atom);
                Expression { tokens: quote!(-#inner), level: Level::Sum, depth: a.depth + 1 }
            }
            Operation::Add(a, b) => self.binary(a, b, Level::Sum, |a, b| quote!(#a + #b)),
            Operation::Subtract(a, b) => self.binary(a, b, Level::Sum, |a, b| quote!(#a - #b)),
            Operation::Multiply(a, b) => self.binary(a, b, Level::Product, |a, b| quote!(#a * #b)),
            Operation::Divide(a, b) => self.binary(a, b, Level::Product, |a, b| quote!(#a / #b)),
        }
    }

    /// Rust's operators group to the left, so only the right operand needs parentheses at its own level.
    fn binary(
        &self,
        a: Node,
        b: Node,
        level: Level,
        join: impl Fn(TokenStream, TokenStream) -> TokenStream,
    ) -> Expression {
        let (a, b) = (self.operand(a), self.operand(b));
        let tighter = if level == Level::Sum { Level::Product } else { Level::Atom };
        let depth = a.depth.max(b.depth) + 1;
        Expression { tokens: join(grouped(&a, level), grouped(&b, tighter)), level, depth }
    }

    /// A use of a step.
    fn operand(&self, node: Node) -> Expression {
        let atom = |tokens| Expression { tokens, level: Level::Atom, depth: 0 };
        match (&self.names[node.0], &self.expressions[node.0]) {
            (Some(name), _) => atom(quote!(#name.clone())),
            (None, Some(expression)) => expression.clone(),
            (None, None) => atom(TokenStream::new()),
        }
    }

    /// `__t_eps_x` for the product ε·x, `__c_3` for a constant, else `__sum_1`, `__product_2` by what it is.
    fn name_of(&mut self, node: Node) -> Ident {
        if let Operation::Constant(value) = &self.plan.operations[node.0]
            && let Some((numerator, denominator)) = value.as_small_ratio()
        {
            return if denominator == 1 {
                format_ident!("__c_{numerator}")
            } else {
                format_ident!("__c_{numerator}_{denominator}")
            };
        }
        // States `x_y`, `z` and `x`, `y_z` have the same product name: the second one is numbered.
        match self.product_name(node).filter(|factors| self.products.insert(factors.clone())) {
            Some(factors) => format_ident!("__t_{factors}"),
            None => {
                self.counter += 1;
                let what = match &self.plan.operations[node.0] {
                    Operation::Multiply(..) => "product",
                    Operation::Divide(..) => "quotient",
                    Operation::Negate(_) => "negative",
                    _ => "sum",
                };
                format_ident!("__{what}_{}", self.counter)
            }
        }
    }

    /// The names of the inputs of a short product of inputs.
    fn product_name(&self, node: Node) -> Option<String> {
        match &self.plan.operations[node.0] {
            Operation::Input(variable) => Some(self.symbols.name(*variable).replace('\'', "_second")),
            Operation::Multiply(a, b) => {
                let name = format!("{}_{}", self.product_name(*a)?, self.product_name(*b)?);
                (name.len() <= 24).then_some(name)
            }
            _ => None,
        }
    }
}

fn grouped(expression: &Expression, at_least: Level) -> TokenStream {
    let tokens = &expression.tokens;
    if expression.level >= at_least { tokens.clone() } else { quote!((#tokens)) }
}

/// The name that a variable is bound to.
fn binding(symbols: &Symbols, variable: Variable) -> Ident {
    match symbols.symbol(variable) {
        Symbol::State(i) => format_ident!("__s_{}", symbols.states[i]),
        Symbol::Parameter(k) => format_ident!("__p_{}", symbols.parameters[k]),
        Symbol::Epsilon => format_ident!("__half_step"),
        Symbol::SecondState(i) => format_ident!("__o_{}", symbols.states[i]),
    }
}

/// Binds what a plan reads: `let [__s_x, _, __s_z] = __kahan::components(__state);`, the parameters from `system`; ε stands in
/// `__half_step`, the second point in `__other`.
pub(super) fn emit_inputs(plan: &Plan, symbols: &Symbols, system: &TokenStream) -> TokenStream {
    let inputs = plan.inputs();
    let pattern = |symbol: &dyn Fn(usize) -> Symbol| {
        let variables: Vec<Variable> =
            (0..symbols.dimension()).map(|i| symbols.variable(symbol(i))).collect();
        let is_read = variables.iter().any(|variable| inputs.contains(variable));
        let names = variables.into_iter().map(|variable| {
            let name = binding(symbols, variable);
            if inputs.contains(&variable) { quote!(#name) } else { quote!(_) }
        });
        is_read.then(|| quote!([#(#names),*]))
    };
    let mut bindings = TokenStream::new();
    if let Some(states) = pattern(&Symbol::State) {
        bindings.extend(quote! { let #states = __kahan::components(__state); });
    }
    if let Some(states) = pattern(&Symbol::SecondState) {
        bindings.extend(quote! { let #states = __kahan::components(__other); });
    }
    for (k, parameter) in symbols.parameters.iter().enumerate() {
        let variable = symbols.parameter(k);
        if inputs.contains(&variable) {
            let (name, field) = (
                binding(symbols, variable),
                super::items::identifier(parameter, proc_macro2::Span::call_site()),
            );
            bindings.extend(quote! { let #name = &#system.#field; });
        }
    }
    bindings
}
