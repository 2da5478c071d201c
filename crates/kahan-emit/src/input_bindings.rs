//! Emits bindings for the inputs of plans.

use kahan_algebra::plan::{Plan, variables};
use kahan_algebra::poly::Variable;
use kahan_algebra::symbols::{Symbol, Symbols};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::items::identifier;

pub(super) fn binding(symbols: &Symbols, variable: Variable) -> Ident {
    match symbols.symbol(variable) {
        Symbol::State(i) => format_ident!("__s_{}", symbols.states[i]),
        Symbol::Parameter(k) => format_ident!("__p_{}", symbols.parameters[k]),
        Symbol::Epsilon => format_ident!("eps"),
        Symbol::SecondState(i) => format_ident!("__o_{}", symbols.states[i]),
    }
}

/// Binds the inputs of a plan, as in `let [__s_x, _, __s_z] = __kahan::components(x);`.
pub(super) fn emit_inputs(plan: &Plan, symbols: &Symbols) -> TokenStream {
    let inputs = variables(plan);
    let mut bindings = TokenStream::new();
    let kinds: [fn(usize) -> Symbol; 2] = [Symbol::State, Symbol::SecondState];
    for (symbol, point) in kinds.into_iter().zip([quote!(x), quote!(y)]) {
        if let Some(states) = emit_pattern(&inputs, symbols, symbol, symbols.dimension()) {
            bindings.extend(quote! { let #states = __kahan::components(#point); });
        }
    }
    bindings.extend(emit_bound_parameters(&inputs, symbols, |field| quote!(&self.#field)));
    bindings
}

/// For each parameter in `inputs`, binds its name to the expression that `read` returns.
pub(super) fn emit_bound_parameters(
    inputs: &[Variable],
    symbols: &Symbols,
    read: impl Fn(Ident) -> TokenStream,
) -> TokenStream {
    let all = symbols.parameters.iter().enumerate();
    let given = all.map(|(k, name)| (symbols.parameter(k), identifier(name, Span::call_site())));
    let binds = |(variable, field)| {
        let (name, value) = (binding(symbols, variable), read(field));
        quote! { let #name = #value; }
    };
    given.filter(|(variable, _)| inputs.binary_search(variable).is_ok()).map(binds).collect()
}

/// Binds all states at the start, because code that binds each at its first use vectorises worse.
pub(super) fn emit_owned_states(plan: &Plan, symbols: &Symbols) -> TokenStream {
    let states = emit_pattern(&variables(plan), symbols, Symbol::State, symbols.dimension());
    states.map(|states| quote! { let #states = __state; }).unwrap_or_default()
}

/// Returns a pattern that binds those components of a point that occur among the sorted `inputs`.
pub(super) fn emit_pattern(
    inputs: &[Variable],
    symbols: &Symbols,
    symbol: impl Fn(usize) -> Symbol,
    dimension: usize,
) -> Option<TokenStream> {
    let variables = (0..dimension).map(|i| symbols.variable(symbol(i)));
    let names: Vec<Option<Ident>> = variables
        .map(|variable| inputs.binary_search(&variable).ok().map(|_| binding(symbols, variable)))
        .collect();
    let shown = names.iter().map(|name| name.as_ref().map_or_else(|| quote!(_), |name| quote!(#name)));
    names.iter().any(Option::is_some).then(|| quote!([#(#shown),*]))
}
