//! The prepared step: what ε and the parameters fix, computed once, and the kernel that a state runs through.
//!
//! ```text
//! pub struct __Step<T> { eps: Apart<T>, two_eps: Apart<T> }
//! impl<T: Scalar> PreparedStep<T, 3> for __Step<T> { fn quotients(&self, x) … }  // the kernel
//! impl<T: Scalar> WideStep<T, 3> for __Step<T> { fn widen … }                          // the same over lanes
//! ```
//!
//! Where lanes have a plan of their own, it is a `__General<T>`, which `__Step<T>` holds as `__general`. A step divided by ε takes
//! that one, too, unless ε is an ordinary float, which `__is_inverse` remembers.

use kahan_algebra::plan::{Node, Plan, StepCost, StepPlan};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Context;
use super::inputs::{emit_inputs, emit_owned_inputs};
use super::names::constant_names;
use super::plan::{Emitted, emit_kernel, emit_plan};

/// The parts of a prepared step.
pub(super) struct EmittedStep {
    /// The type and what it implements.
    pub(super) items: TokenStream,
    /// The body of `prepare(&self, eps: &T) -> __Step<T>`.
    pub(super) prepare: TokenStream,
}

/// The name of the step, and of the one that it holds.
const STEP: &str = "__Step";
const GENERAL: &str = "__General";

/// The number of components for which intermediate values are kept from being packed into vectors.
///
/// Of three components one is left over from every pair, and the shuffles cost up to an eighth of a step. Two make one vector; for
/// more, what says it would make steps so large that compilers no longer inline them into loops.
const ALONE: usize = 3;

/// Emits the step of a plan.
pub(super) fn emit_step(context: &Context<'_>, plan: &StepPlan) -> EmittedStep {
    let general = plan.general.as_deref().map(|general| Kernel::of(context, general, GENERAL, None));
    let step = Kernel::of(context, plan, STEP, general.as_ref());
    let items = [Some(&step), general.as_ref()].into_iter().flatten().map(|kernel| {
        let (definition, implementation) = (kernel.emit_struct(), kernel.emit_prepared_step());
        quote! { #definition #implementation }
    });
    let wide = step.emit_wide_step();
    EmittedStep { items: quote! { #(#items)* #wide }, prepare: step.emit_prepare() }
}

/// One prepared step.
struct Kernel<'a> {
    context: &'a Context<'a>,
    plan: &'a StepPlan,
    name: Ident,
    /// The names of the constants.
    names: Vec<Ident>,
    /// The one for lanes, and for what this one does not serve, that this one holds.
    general: Option<&'a Kernel<'a>>,
}

impl<'a> Kernel<'a> {
    fn of(context: &'a Context<'a>, plan: &'a StepPlan, name: &str, general: Option<&'a Kernel<'a>>) -> Self {
        let names = constant_names(&plan.constants, &context.system.field.symbols);
        Kernel { context, plan, name: format_ident!("{name}"), names, general }
    }

    /// Expands to `pub struct __Step<T> { eps: Apart<T> }`; a step without constants still knows its scalar.
    fn emit_struct(&self) -> TokenStream {
        let (name, names, scalar) = (&self.name, &self.names, &self.context.scalar);
        let general = self.general.map(|Kernel { name, .. }| quote!(__general: #name<#scalar>,));
        let is_inverse = self.is_inverse().then(|| quote!(__is_inverse: __kahan::core::primitive::bool,));
        let marker = self.marker().map(|marker| quote!(__scalar: #marker<#scalar>));
        quote! {
            #[::core::prelude::v1::derive(::core::clone::Clone, ::core::marker::Copy)]
            pub struct #name<#scalar> { #(#names: __kahan::Apart<#scalar>,)* #general #is_inverse #marker }
        }
    }

    /// Whether the constants divide by ε.
    fn is_inverse(&self) -> bool {
        self.plan.has_inverse_step()
    }

    fn marker(&self) -> Option<TokenStream> {
        let is_empty = self.names.is_empty() && self.general.is_none();
        is_empty.then(|| quote!(__kahan::core::marker::PhantomData))
    }

    /// Expands to the constants, in a value of the struct.
    fn emit_prepare(&self) -> TokenStream {
        let (name, names, scalar) = (&self.name, &self.names, &self.context.scalar);
        let symbols = &self.context.system.field.symbols;
        let inputs = emit_inputs(&self.plan.constants, symbols);
        let Emitted { bindings, results } = emit_plan(&self.plan.constants, symbols, scalar);
        let general = self.general.map(|general| {
            let prepare = general.emit_prepare();
            quote!(let __general = { #prepare };)
        });
        let divisor = self.is_inverse().then(|| {
            quote! {
                let (__is_inverse, __divisor) = __kahan::divisor(eps);
                let eps = &__divisor;
            }
        });
        let held = self.general.map(|_| quote!(__general,));
        let is_inverse = self.is_inverse().then(|| quote!(__is_inverse,));
        let marker = self.marker().map(|marker| quote!(__scalar: #marker));
        quote! {
            #general #divisor #inputs #bindings
            #name { #(#names: __kahan::Apart::new(#results),)* #held #is_inverse #marker }
        }
    }

    /// Expands to `impl<T: Scalar> PreparedStep<T, 3> for __Step<T>`.
    fn emit_prepared_step(&self) -> TokenStream {
        let Kernel { context, plan, name, names, .. } = self;
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
        let inputs = emit_owned_inputs(&kernel, symbols);
        let Emitted { bindings, results } = emit_kernel(&kernel, symbols, scalar, names, n == ALONE);
        let cost = emit_cost(plan);
        // Two reciprocals are one after the other: a component that waits for the first alone closes the cycle.
        let packs = (reciprocals.len() > 1).then(|| {
            quote!(
                const PACKS: __kahan::core::primitive::bool = false;
            )
        });
        let otherwise = self.is_inverse().then(|| self.emit_otherwise());
        let has_inverse_step = self.is_inverse().then(|| {
            quote!(
                const HAS_INVERSE_STEP: __kahan::core::primitive::bool = true;
            )
        });
        let mut results = results.into_iter();
        let numerators: Vec<TokenStream> = results.by_ref().take(n).collect();
        let reciprocals = of_components.iter().map(|reciprocal| match reciprocal {
            Some(_) => {
                let reciprocal = results.next().unwrap_or_default();
                quote!(__kahan::Option::Some(#reciprocal))
            }
            None => quote!(__kahan::Option::None),
        });
        quote! {
            impl<#scalar: __kahan::Scalar> __kahan::PreparedStep<#scalar, #dimension> for #name<#scalar> {
                #cost
                #packs
                #has_inverse_step
                #[inline(always)]
                fn quotients(
                    &self,
                    x: &#vector,
                ) -> __kahan::Option<__kahan::Quotients<#scalar, #dimension>> {
                    #otherwise
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

    /// Expands to the way out of a kernel that is divided by ε: the general step's quotients, and for floats, which call it, its
    /// increments as quotients of this kernel's kind.
    fn emit_otherwise(&self) -> TokenStream {
        let scalar = &self.context.scalar;
        let increments: Vec<Ident> =
            (1..=self.plan.reciprocals.len()).map(|i| format_ident!("__increment_{i}")).collect();
        let reciprocals = self.plan.reciprocals.iter().map(|place| match place {
            Some(_) => quote!(__kahan::Option::Some(__kahan::integer::<#scalar>(1))),
            None => quote!(__kahan::Option::None),
        });
        quote! {
            if !#scalar::HAS_INVERSE_STEPS || !(#scalar::CALLS_GENERAL_STEP || self.__is_inverse) {
                return self.__general.quotients(x);
            }
            if !self.__is_inverse {
                let x = __kahan::vector(__kahan::components(x).clone());
                let [#(#increments),*] = __kahan::general_increment(&self.__general, x);
                return __kahan::Option::Some(__kahan::Quotients {
                    numerators: [#(#increments),*],
                    reciprocals: [#(#reciprocals),*],
                });
            }
        }
    }

    /// Expands to `impl<T: Scalar> WideStep<T, 3> for __Step<T>`.
    fn emit_wide_step(&self) -> TokenStream {
        let (name, scalar, dimension) = (&self.name, &self.context.scalar, &self.context.dimension);
        let wide = self.general.unwrap_or(self);
        let (wide_name, names) = (&wide.name, &wide.names);
        let holder = if self.general.is_some() { quote!(self.__general) } else { quote!(self) };
        let marker = wide.marker().map(|marker| quote!(__scalar: #marker));
        quote! {
            impl<#scalar: __kahan::Scalar> __kahan::WideStep<#scalar, #dimension> for #name<#scalar> {
                const HAS_LANES: __kahan::core::primitive::bool = true;
                type Wide<__L: __kahan::Scalar> = #wide_name<__L>;
                #[inline(always)]
                fn widen<__L: __kahan::Scalar>(
                    &self,
                    __spread: impl __kahan::core::ops::Fn(&#scalar) -> __L,
                ) -> #wide_name<__L> {
                    #wide_name { #(#names: __kahan::Apart::new(__spread(&#holder.#names.0)),)* #marker }
                }
            }
        }
    }
}

/// Expands to `const COST: StepCost = StepCost { … };`.
fn emit_cost(plan: &StepPlan) -> TokenStream {
    let StepCost { operations, divisions, chain } = plan.cost();
    let [operations, divisions, chain] = [operations, divisions, chain].map(Literal::u32_unsuffixed);
    quote! {
        const COST: __kahan::StepCost =
            __kahan::StepCost { operations: #operations, divisions: #divisions, chain: #chain };
    }
}
