//! Emits the prepared step: constants, which depend on ε and the parameters, and the kernel.
//!
//! ```text
//! pub struct __Step;
//! impl Kernel<3, 2> for __Step { const COST …; fn quotients(constants, state) … }
//! ```
//!
//! If a plan has a second form, which suits all scalars, the type `__General` is emitted too.

use kahan_algebra::plan::{Node, Plan, StepCost, StepPlan};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Context;
use super::input_bindings::{emit_inputs, emit_owned_states};
use super::plan::{Emitted, emit_kernel, emit_plan};
use kahan_algebra::derived::constant_names;

pub(super) struct EmittedStep {
    pub(super) items: TokenStream,
    pub(super) prepared: TokenStream,
    pub(super) prepare: TokenStream,
}

pub(super) fn emit_step(context: &Context<'_>, plan: &StepPlan) -> EmittedStep {
    let scalar = &context.this.scalar;
    let step = NamedStep::of(context, plan, "__Step");
    let (items, constants) = (step.emit_kernel(), step.emit_constants());
    let (name, count) = (&step.name, step.count());
    let Some(general) = plan.general.as_deref() else {
        return EmittedStep {
            items,
            prepared: quote!(__kahan::StraightStep<#name, #scalar, #count>),
            prepare: quote!(Self::Prepared::new(#constants)),
        };
    };
    let general = NamedStep::of(context, general, "__General");
    let (its_items, its_constants) = (general.emit_kernel(), general.emit_constants());
    let (its_name, its_count) = (&general.name, general.count());
    let (both, at) = if plan.has_inverse_step {
        (quote!(StepOverEps), quote!(eps,))
    } else {
        (quote!(StepOfOneOrbit), quote!())
    };
    EmittedStep {
        items: quote! { #items #its_items },
        prepared: quote!(__kahan::#both<#name, #its_name, #scalar, #count, #its_count>),
        prepare: quote! { Self::Prepared::new(#at || #constants, || #its_constants) },
    }
}

struct NamedStep<'a> {
    context: &'a Context<'a>,
    plan: &'a StepPlan,
    name: Ident,
    names: Vec<String>,
}

impl<'a> NamedStep<'a> {
    fn of(context: &'a Context<'a>, plan: &'a StepPlan, name: &str) -> Self {
        let names = constant_names(&plan.constants, &context.system.field.symbols);
        NamedStep { context, plan, name: format_ident!("{name}"), names }
    }

    fn count(&self) -> Literal {
        Literal::usize_unsuffixed(self.names.len())
    }

    /// Expands to the array of constants: `[eps.clone(), …]`, or a block that computes it.
    fn emit_constants(&self) -> TokenStream {
        let symbols = &self.context.system.field.symbols;
        let inputs = emit_inputs(&self.plan.constants, symbols);
        let Emitted { bindings, results } =
            emit_plan(&self.plan.constants, symbols, &self.context.this.scalar);
        let constants = quote!([#(#results),*]);
        if inputs.is_empty() && bindings.is_empty() {
            constants
        } else {
            quote! { { #inputs #bindings #constants } }
        }
    }

    fn emit_kernel(&self) -> TokenStream {
        let NamedStep { context, plan, name, names } = self;
        let (scalar, dimension, count) = (&context.this.scalar, &context.dimension, self.count());
        let n = context.system.field.dimension();
        let of_step = &plan.kernel;
        let reciprocals = of_step.reciprocals();
        let is_shared = reciprocals.len() == 1 && of_step.reciprocal_of.iter().all(Option::is_some);
        // Unless all results share one reciprocal, the kernel outputs a reciprocal once for each of
        // its uses. This saves a clone.
        let uses: Vec<Node> = if is_shared {
            reciprocals.to_vec()
        } else {
            of_step.factors(&of_step.plan.outputs).filter_map(|(_, reciprocal)| reciprocal.copied()).collect()
        };
        let kernel = Plan {
            operations: of_step.plan.operations.clone(),
            outputs: of_step.numerators().iter().copied().chain(uses).collect(),
        };
        let symbols = &context.system.field.symbols;
        let states = emit_owned_states(&kernel, symbols);
        let Emitted { bindings, results } =
            emit_kernel(&kernel, symbols, scalar, names, plan.fences_values());
        let mut results = results.into_iter();
        let numerators: Vec<TokenStream> = results.by_ref().take(n).collect();
        let quotients = if is_shared {
            quote!(__kahan::Some(__kahan::Quotients::over([#(#numerators),*], #(#results)*)))
        } else if reciprocals.is_empty() {
            quote!(__kahan::Some(__kahan::Quotients::whole([#(#numerators),*])))
        } else {
            let each = of_step.reciprocal_of.iter().map(|place| match place.and_then(|_| results.next()) {
                Some(reciprocal) => quote!(__kahan::Some(#reciprocal)),
                None => quote!(__kahan::None),
            });
            let each: Vec<TokenStream> = each.collect();
            let over = if reciprocals.len() == 1 { quote!(over_each) } else { quote!(over_several) };
            quote!(__kahan::Some(__kahan::Quotients::#over([#(#numerators),*], [#(#each),*])))
        };
        let (cost, constants) =
            (emit_cost(plan.cost()), names.iter().map(|name| format_ident!("__e_{name}")));
        quote! {
            pub struct #name;
            impl __kahan::Kernel<#dimension, #count> for #name {
                #cost
                #[inline(always)]
                fn quotients<#scalar: __kahan::Scalar>(
                    __constants: &[__kahan::Padded<#scalar>; #count],
                    __state: [#scalar; #dimension],
                ) -> __kahan::Option<__kahan::Quotients<#scalar, #dimension>> {
                    let [#(#constants),*] = __constants;
                    #states
                    #bindings
                    #quotients
                }
            }
        }
    }
}

pub(super) fn emit_cost(cost: StepCost) -> TokenStream {
    let StepCost { operations, divisions, critical_path } = cost;
    let [operations, divisions, critical_path] =
        [operations, divisions, critical_path].map(Literal::u32_unsuffixed);
    quote! {
        const COST: __kahan::StepCost = __kahan::StepCost::of(#operations, #divisions, #critical_path);
    }
}
