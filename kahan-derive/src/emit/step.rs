//! The prepared step: what ε and the parameters fix, computed once, and the kernel that a state runs through.
//!
//! ```text
//! pub struct __Step<T> { eps: Apart<T>, two_eps: Apart<T> }
//! impl<T: Scalar> PreparedStep<T, 3> for __Step<T> { fn quotients(&self, __state) … }  // the kernel
//! impl<T: Scalar> WideStep<T, 3> for __Step<T> { fn widen … }                          // the same over lanes
//! ```

use kahan_algebra::plan::{Node, Plan, StepPlan};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::Context;
use super::inputs::emit_inputs;
use super::names::constant_names;
use super::plan::{emit_kernel, emit_plan};

/// The parts of a prepared step.
pub(super) struct EmittedStep {
    /// The type and what it implements.
    pub(super) items: TokenStream,
    /// The body of `prepare(&self, __half_step: &T) -> __Step<T>`.
    pub(super) prepare: TokenStream,
}

/// Emits the step of a plan.
pub(super) fn emit_step(context: &Context<'_>, plan: &StepPlan) -> EmittedStep {
    let names = constant_names(&plan.constants, &context.system.field.symbols);
    let definition = emit_struct(context, &names);
    let kernel = emit_prepared_step(context, plan, &names);
    let wide = emit_wide_step(context, &names);
    EmittedStep { items: quote! { #definition #kernel #wide }, prepare: emit_prepare(context, plan, &names) }
}

/// A step without constants still knows its scalar.
fn marker(names: &[Ident]) -> Option<TokenStream> {
    names.is_empty().then(|| quote!(__kahan::core::marker::PhantomData))
}

fn emit_struct(context: &Context<'_>, names: &[Ident]) -> TokenStream {
    let scalar = &context.scalar;
    let fields = match marker(names) {
        Some(marker) => quote!((#marker<#scalar>);),
        None => quote!({ #(#names: __kahan::Apart<#scalar>),* }),
    };
    quote! {
        #[::core::prelude::v1::derive(::core::clone::Clone, ::core::marker::Copy)]
        pub struct __Step<#scalar> #fields
    }
}

/// Expands to the constants in the order of their names.
fn emit_prepare(context: &Context<'_>, plan: &StepPlan, names: &[Ident]) -> TokenStream {
    if let Some(marker) = marker(names) {
        return quote!(__Step(#marker));
    }
    let symbols = &context.system.field.symbols;
    let inputs = emit_inputs(&plan.constants, symbols);
    let emitted = emit_plan(&plan.constants, symbols, &context.scalar);
    let (bindings, results) = (emitted.bindings, emitted.results);
    quote! { #inputs #bindings __Step { #(#names: __kahan::Apart(#results)),* } }
}

/// Expands to `impl<T: Scalar> PreparedStep<T, 3> for __Step<T>`.
fn emit_prepared_step(context: &Context<'_>, plan: &StepPlan, names: &[Ident]) -> TokenStream {
    let (scalar, dimension, vector) = (&context.scalar, &context.dimension, context.vector());
    let n = context.system.field.dimension();
    let (numerators, reciprocals) = plan.kernel.outputs.split_at(n);
    // One result for each use: a shared reciprocal is moved into its last component.
    let of_components: Vec<Option<Node>> =
        plan.reciprocals.iter().map(|place| place.map(|place| reciprocals[place])).collect();
    let kernel = Plan {
        operations: plan.kernel.operations.clone(),
        outputs: numerators.iter().copied().chain(of_components.iter().copied().flatten()).collect(),
    };
    let symbols = &context.system.field.symbols;
    let inputs = emit_inputs(&kernel, symbols);
    let emitted = emit_kernel(&kernel, symbols, scalar, names);
    let bindings = emitted.bindings;
    let mut results = emitted.results.into_iter();
    let numerators: Vec<TokenStream> = results.by_ref().take(n).collect();
    let reciprocals = of_components.iter().map(|reciprocal| match reciprocal {
        Some(_) => results.next().unwrap_or_default(),
        None => quote!(__kahan::integer::<#scalar>(1)),
    });
    quote! {
        impl<#scalar: __kahan::Scalar> __kahan::PreparedStep<#scalar, #dimension> for __Step<#scalar> {
            #[inline(always)]
            fn quotients(
                &self,
                __state: &#vector,
            ) -> __kahan::Option<__kahan::Quotients<#scalar, #dimension>> {
                #inputs
                #bindings
                __kahan::Option::Some(__kahan::Quotients {
                    numerators: [#(#numerators),*],
                    reciprocals: [#(#reciprocals),*],
                })
            }
        }
    }
}

/// Expands to `impl<T: Scalar> WideStep<T, 3> for __Step<T>`.
fn emit_wide_step(context: &Context<'_>, names: &[Ident]) -> TokenStream {
    let (scalar, dimension) = (&context.scalar, &context.dimension);
    let value = match marker(names) {
        Some(marker) => quote!(__Step(#marker)),
        None => quote!(__Step { #(#names: __kahan::Apart(__spread(&self.#names.0))),* }),
    };
    quote! {
        impl<#scalar: __kahan::Scalar> __kahan::WideStep<#scalar, #dimension> for __Step<#scalar> {
            const HAS_LANES: __kahan::core::primitive::bool = true;
            type Wide<__L: __kahan::Scalar> = __Step<__L>;
            #[inline(always)]
            fn widen<__L: __kahan::Scalar>(
                &self,
                __spread: impl __kahan::core::ops::Fn(&#scalar) -> __L,
            ) -> __Step<__L> {
                #value
            }
        }
    }
}
