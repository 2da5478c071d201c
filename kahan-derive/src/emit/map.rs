//! `KahanMap`: the increment x̃ − x from the reduced map, and the closed forms of N and D; or elimination, where the
//! closed forms are beyond the budget.

use kahan_algebra::kahan::RationalMap;
use kahan_algebra::plan::PlanBuilder;
use proc_macro2::{Span, TokenStream};
use quote::quote;

use super::Context;
use super::items::identifier;
use super::plan::{emit_inputs, emit_plan};

/// Expands to `impl<T: Scalar> KahanMap<T, 3> for E6 { … }`.
pub(super) fn emit_map(context: &Context<'_>) -> TokenStream {
    let Some(map) = &context.map else { return emit_elimination(context) };
    let reduced = emit_reduced(context, map);
    let (determinant, rational_map) = (emit_determinant(context, map), emit_rational_map(context, map));
    let lifted = emit_lifted(context);
    let (this, scalar, dimension) = (context.self_type(), &context.scalar, &context.dimension);
    let (vector, matrix) = (context.vector(), context.matrix());
    quote! {
        #reduced
        impl<#scalar: __kahan::Scalar> __kahan::KahanMap<#scalar, #dimension> for #this {
            fn increment(&self, __state: &#vector, __half_step: &#scalar) -> __kahan::Option<#vector> {
                let (__numerators, __denominator) = __reduced(self, __state, __half_step);
                __kahan::increment_from_quotient(__numerators, __denominator, __half_step)
            }
            fn jacobian(&self, __state: &#vector, __half_step: #scalar) -> #matrix {
                let __lifted = #lifted;
                __kahan::jacobian_of_reduced(
                    |__state, __half_step| {
                        let (__numerators, __denominator) = __reduced(&__lifted, __state, __half_step);
                        __kahan::increment_from_quotient(__numerators, __denominator, __half_step)
                    },
                    __state,
                    &__half_step,
                )
            }
            fn det_matrix(&self, __state: &#vector, __half_step: #scalar) -> #scalar {
                #determinant
            }
            fn rational_map(&self, __state: &#vector, __half_step: #scalar) -> (#vector, #scalar) {
                #rational_map
            }
        }
    }
}

/// Beyond the budget everything but the increment is a default method.
fn emit_elimination(context: &Context<'_>) -> TokenStream {
    let (this, scalar, dimension, vector) =
        (context.self_type(), &context.scalar, &context.dimension, context.vector());
    quote! {
        impl<#scalar: __kahan::Scalar> __kahan::KahanMap<#scalar, #dimension> for #this {
            fn increment(&self, __state: &#vector, __half_step: &#scalar) -> __kahan::Option<#vector> {
                __kahan::increment_by_elimination(self, __state, __half_step)
            }
        }
    }
}

/// Expands to `fn __reduced(system, state, half_step) -> (n, d)` with x̃ = x + 2ε n/d in lowest terms; generic, because the
/// Jacobian runs it on dual numbers.
fn emit_reduced(context: &Context<'_>, map: &RationalMap) -> TokenStream {
    let symbols = &context.system.field.symbols;
    let mut builder = PlanBuilder::default();
    let mut outputs: Vec<_> =
        map.reduced.increments.iter().map(|increment| builder.polynomial(increment)).collect();
    outputs.push(builder.polynomial(&map.reduced.denominator));
    let plan = builder.finish(&outputs);
    let inputs = emit_inputs(&plan, symbols, &quote!(__system));
    let emitted = emit_plan(&plan, symbols, &context.scalar);
    let (bindings, mut increments) = (emitted.bindings, emitted.results);
    let denominator = increments.pop();
    let (this, scalar, vector) = (context.self_type(), &context.scalar, context.vector());
    quote! {
        fn __reduced<#scalar: __kahan::Scalar>(
            __system: &#this,
            __state: &#vector,
            __half_step: &#scalar,
        ) -> (#vector, #scalar) {
            #inputs
            #bindings
            (__kahan::vector([#(#increments),*]), #denominator)
        }
    }
}

/// `E7 { xi: Dual::lift(self.xi.clone()) }`: the same system over dual numbers.
fn emit_lifted(context: &Context<'_>) -> TokenStream {
    let name = &context.name;
    if !context.has_parameters() {
        return quote!(#name);
    }
    let fields = context.system.field.symbols.parameters.iter().map(|parameter| {
        let field = identifier(parameter, Span::call_site());
        quote!(#field: __kahan::Dual::lift(self.#field.clone()))
    });
    quote!(#name { #(#fields),* })
}

/// D = D̂/∏q.
fn emit_determinant(context: &Context<'_>, map: &RationalMap) -> TokenStream {
    let symbols = &context.system.field.symbols;
    let mut builder = PlanBuilder::default();
    let (above, below) = (builder.polynomial(&map.denominator), builder.polynomial(&map.divisor));
    let quotient = builder.divide(above, below);
    let plan = builder.finish(&[quotient]);
    let inputs = emit_inputs(&plan, symbols, &quote!(self));
    let emitted = emit_plan(&plan, symbols, &context.scalar);
    let (bindings, results) = (emitted.bindings, emitted.results);
    quote! { #inputs #bindings #(#results)* }
}

/// (N, D) = (N̂, D̂)/∏q, without a division by anything that depends on the state.
fn emit_rational_map(context: &Context<'_>, map: &RationalMap) -> TokenStream {
    let symbols = &context.system.field.symbols;
    let mut builder = PlanBuilder::default();
    let below = builder.polynomial(&map.divisor);
    let mut outputs = Vec::new();
    for polynomial in map.numerators.iter().chain([&map.denominator]) {
        let above = builder.polynomial(polynomial);
        outputs.push(builder.divide(above, below));
    }
    let plan = builder.finish(&outputs);
    let inputs = emit_inputs(&plan, symbols, &quote!(self));
    let emitted = emit_plan(&plan, symbols, &context.scalar);
    let (bindings, mut numerators) = (emitted.bindings, emitted.results);
    let denominator = numerators.pop();
    quote! { #inputs #bindings (__kahan::vector([#(#numerators),*]), #denominator) }
}
