//! What a plan reads, bound to names.

use kahan_algebra::plan::Plan;
use kahan_algebra::poly::Variable;
use kahan_algebra::symbols::{Symbol, Symbols};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::items::identifier;

/// The name that a variable is bound to.
pub(super) fn binding(symbols: &Symbols, variable: Variable) -> Ident {
    match symbols.symbol(variable) {
        Symbol::State(i) => format_ident!("__s_{}", symbols.states[i]),
        Symbol::Parameter(k) => format_ident!("__p_{}", symbols.parameters[k]),
        Symbol::Epsilon => format_ident!("eps"),
        Symbol::SecondState(i) => format_ident!("__o_{}", symbols.states[i]),
    }
}

/// Binds what a plan reads: `let [__s_x, _, __s_z] = __kahan::components(x);`, the parameters from
/// `self`; ε stands in `eps`, the second point in `y`.
pub(super) fn emit_inputs(plan: &Plan, symbols: &Symbols) -> TokenStream {
    emit_inputs_as(plan, symbols, &TokenStream::new())
}

/// The same for a kernel, the states as values: `let [__s_x, _, __s_z] =
/// __kahan::components(x).clone();`.
///
/// All are read before anything is computed. Read where they are used first, they come in an order in which compilers that
/// pack scalar code into vectors pair them badly, at the cost of a tenth of a large step.
pub(super) fn emit_owned_inputs(plan: &Plan, symbols: &Symbols) -> TokenStream {
    emit_inputs_as(plan, symbols, &quote!(.clone()))
}

fn emit_inputs_as(plan: &Plan, symbols: &Symbols, taken: &TokenStream) -> TokenStream {
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
        bindings.extend(quote! { let #states = __kahan::components(x) #taken; });
    }
    if let Some(states) = pattern(&Symbol::SecondState) {
        bindings.extend(quote! { let #states = __kahan::components(y) #taken; });
    }
    for (k, parameter) in symbols.parameters.iter().enumerate() {
        let variable = symbols.parameter(k);
        if inputs.contains(&variable) {
            let (name, field) = (binding(symbols, variable), identifier(parameter, Span::call_site()));
            bindings.extend(quote! { let #name = &self.#field; });
        }
    }
    bindings
}
