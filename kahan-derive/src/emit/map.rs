//! `KahanMap`: how the step is prepared, and the closed forms of N and D where they are within the budget.

use kahan_algebra::kahan::RationalMap;
use kahan_algebra::objects::{det_matrix_plan, rational_map_plan};
use kahan_algebra::plan::Plan;
use proc_macro2::{Span, TokenStream};
use quote::quote;

use super::Context;
use super::inputs::emit_inputs;
use super::items::identifier;
use super::plan::{Emitted, emit_plan};
use super::step::{EmittedStep, emit_step};

/// Expands to the prepared step and `impl<T: Scalar> KahanMap<T, 3> for E6 { … }`; what is not written here, is a default
/// method.
pub(super) fn emit_map(context: &Context<'_>) -> TokenStream {
    let (this, scalar, dimension) = (context.self_type(), &context.scalar, &context.dimension);
    let (items, prepared) = match &context.step {
        Some(step) => {
            let EmittedStep { items, prepare } = emit_step(context, step);
            (items, emit_prepared(context, &prepare))
        }
        None => (TokenStream::new(), emit_elimination(context)),
    };
    let closed_forms = context.map.as_ref().map(|map| emit_closed_forms(context, map));
    quote! {
        #items
        impl<#scalar: __kahan::Scalar> __kahan::KahanMap<#scalar, #dimension> for #this {
            #prepared
            #closed_forms
        }
    }
}

/// The step of a plan, and the Jacobian by running it on dual numbers.
fn emit_prepared(context: &Context<'_>, prepare: &TokenStream) -> TokenStream {
    let (scalar, vector, matrix) = (&context.scalar, context.vector(), context.matrix());
    let lifted = emit_lifted(context);
    quote! {
        type Prepared = __Step<#scalar>;
        #[inline(always)]
        fn prepare(&self, __half_step: &#scalar) -> __Step<#scalar> {
            #prepare
        }
        fn jacobian(&self, __state: &#vector, __half_step: #scalar) -> #matrix {
            __kahan::jacobian_by_duals(&#lifted, __state, &__half_step)
        }
    }
}

/// Beyond the budget every step eliminates.
fn emit_elimination(context: &Context<'_>) -> TokenStream {
    let scalar = &context.scalar;
    quote! {
        type Prepared = __kahan::Elimination<Self, #scalar>;
        #[inline]
        fn prepare(&self, __half_step: &#scalar) -> Self::Prepared {
            __kahan::Elimination::new(self.clone(), __half_step.clone())
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

/// D = D̂/∏q, and (N, D) = (N̂, D̂)/∏q, without a division by anything that depends on the state.
fn emit_closed_forms(context: &Context<'_>, map: &RationalMap) -> TokenStream {
    let (above, determinant) = emit_body(context, &det_matrix_plan(map));
    let (bindings, mut numerators) = emit_body(context, &rational_map_plan(map));
    let denominator = numerators.pop();
    let (scalar, vector) = (&context.scalar, context.vector());
    quote! {
        fn det_matrix(&self, __state: &#vector, __half_step: #scalar) -> #scalar {
            #above
            #(#determinant)*
        }
        fn rational_map(&self, __state: &#vector, __half_step: #scalar) -> (#vector, #scalar) {
            #bindings
            (__kahan::vector([#(#numerators),*]), #denominator)
        }
    }
}

/// Inputs and bindings of a plan, and its results.
fn emit_body(context: &Context<'_>, plan: &Plan) -> (TokenStream, Vec<TokenStream>) {
    let symbols = &context.system.field.symbols;
    let inputs = emit_inputs(plan, symbols);
    let Emitted { bindings, results } = emit_plan(plan, symbols, &context.scalar);
    (quote! { #inputs #bindings }, results)
}
