//! Emits `KahanMap`: the step, and formulas for the numerators and the denominator of the map.

use kahan_algebra::elimination::{Couplings, MOST_EXPANDED};
use kahan_algebra::plan::{Plan, variables};
use kahan_algebra::symbols::Symbol;
use proc_macro2::{Span, TokenStream};
use quote::{format_ident, quote};

use super::Context;
use super::coupled::{emit_coupled, emit_parameters, table_sizes};
use super::field::{emit_body, emit_coefficients_of_eps};
use super::input_bindings::{emit_bound_parameters, emit_pattern};
use super::items::identifier;
use super::plan::{Emitted, emit_kernel};
use super::step::{EmittedStep, emit_step};

/// Expands to the code of the step and to the implementation of `KahanMap`.
pub(super) fn emit_map(context: &Context<'_>) -> TokenStream {
    let (this, scalar, dimension) = (context.this.path(), &context.this.scalar, &context.dimension);
    let (items, prepared) = match (context.derived.couplings(), context.derived.step()) {
        (Some(couplings), _) => (emit_coupled(context, couplings), emit_coupled_step(context, couplings)),
        (None, step) => {
            let step = step.unwrap_or_else(|| unreachable!("what has no straight line is eliminated"));
            let EmittedStep { items, prepared, prepare } = emit_step(context, step);
            (items, emit_prepared(context, &prepared, &prepare))
        }
    };
    let promise = if context.system.field.dimension() > MOST_EXPANDED {
        quote!(prepared.promised(self, x))
    } else {
        quote!(__kahan::stable_step(self, prepared, x, eps))
    };
    let (vector, closed_forms) = (context.vector(), emit_closed_forms(context));
    let (coefficients, extension) = (emit_coefficients_of_eps(context), emit_extension(context));
    quote! {
        #items
        impl<#scalar: __kahan::Scalar> __kahan::KahanMap<#scalar, #dimension> for #this {
            #prepared
            #[inline(always)]
            fn try_prepared(
                &self,
                prepared: &Self::Prepared,
                x: &#vector,
                eps: &#scalar,
            ) -> __kahan::Result<#vector, __kahan::SingularStep>
            where
                #scalar: __kahan::Pivot,
            {
                #promise
            }
            #closed_forms
            #coefficients
        }
        #extension
    }
}

/// Emits `prepare`, which computes the step's constants, and `jacobian`, which uses dual numbers.
fn emit_prepared(context: &Context<'_>, prepared: &TokenStream, prepare: &TokenStream) -> TokenStream {
    let (scalar, vector, matrix) = (&context.this.scalar, context.vector(), context.matrix());
    quote! {
        type Prepared = #prepared;
        #[inline(always)]
        fn prepare(&self, eps: &#scalar) -> Self::Prepared {
            #prepare
        }
        fn jacobian(&self, x: &#vector, eps: #scalar) -> #matrix {
            __kahan::jacobian_by_duals(self, x, &eps)
        }
    }
}

/// Emits a step that solves its linear system by sparse elimination, and the Jacobian of this step.
fn emit_coupled_step(context: &Context<'_>, couplings: &Couplings) -> TokenStream {
    let (scalar, vector, matrix) = (&context.this.scalar, context.vector(), context.matrix());
    let dimension = &context.dimension;
    let [parameters, slopes, places] = table_sizes(context, couplings);
    let own = emit_parameters(context, &quote!(eps.clone()));
    quote! {
        type Prepared = __kahan::CoupledStep<__Coupled, #scalar, #dimension, #parameters, #slopes, #places>;
        fn prepare(&self, eps: &#scalar) -> Self::Prepared {
            __kahan::CoupledStep::new(#own, eps.clone())
        }
        fn jacobian(&self, x: &#vector, eps: #scalar) -> #matrix {
            self.prepare(&eps).jacobian(x)
        }
    }
}

fn emit_extension(context: &Context<'_>) -> TokenStream {
    let (this, name, scalar, dimension) =
        (context.this.path(), &context.this.name, &context.this.scalar, &context.dimension);
    let other = format_ident!("{}", if context.this.name == "U" { "V" } else { "U" });
    let carry = emit_carry(context);
    let (extended, value) = if context.this.has_parameters() {
        let fields = context.system.field.symbols.parameters.iter().map(|parameter| {
            let field = identifier(parameter, Span::call_site());
            quote!(#field: convert(&self.#field))
        });
        (quote!(#name<#other>), quote!(#name { #(#fields),* }))
    } else {
        (quote!(#name), quote!(__kahan::Clone::clone(self)))
    };
    quote! {
        impl<#scalar: __kahan::Scalar> __kahan::ExtendScalars<#scalar, #dimension> for #this {
            type Extended<#other: __kahan::Scalar> = #extended;
            #[inline(always)]
            fn extend_scalars<#other: __kahan::Scalar>(
                &self,
                convert: impl __kahan::Fn(&#scalar) -> #other,
            ) -> #extended {
                #value
            }
            #carry
        }
    }
}

/// Emits `carry_tangent`, which multiplies a tangent vector at `x` by the step's Jacobian.
fn emit_carry(context: &Context<'_>) -> Option<TokenStream> {
    let (symbols, plan) = context.derived.tangent_map()?;
    let (scalar, vector, n) = (&context.this.scalar, context.vector(), context.system.field.dimension());
    let inputs = variables(plan);
    let point = |name: &str, symbol: &dyn Fn(usize) -> Symbol| {
        let (pattern, point) = (emit_pattern(&inputs, symbols, symbol, n)?, format_ident!("{name}"));
        Some(quote! { let #pattern = __kahan::components(#point).clone(); })
    };
    let points =
        [point("x", &Symbol::State), point("y", &Symbol::SecondState), point("v", &|i| Symbol::State(n + i))];
    let points = points.into_iter().flatten();
    let parameters = emit_bound_parameters(&inputs, symbols, |field| quote!(self.#field.clone()));
    let Emitted { bindings, results } = emit_kernel(plan, symbols, scalar, &[], n == 3);
    Some(quote! {
        #[inline(always)]
        fn carry_tangent(
            &self,
            eps: &#scalar,
            x: &#vector,
            y: &#vector,
            v: &#vector,
        ) -> __kahan::Option<#vector> {
            let eps = eps.clone();
            #(#points)*
            #parameters
            #bindings
            __kahan::Some(__kahan::vector([#(#results),*]))
        }
    })
}

/// Emits the determinant of the step's matrix, and the numerators and denominators of the map.
fn emit_closed_forms(context: &Context<'_>) -> TokenStream {
    let derived = context.derived;
    let det_matrix = derived.det_matrix.as_ref().map(|plan| {
        let (above, determinant) = emit_body(context, plan);
        let (scalar, vector) = (&context.this.scalar, context.vector());
        quote! {
            fn det_matrix(&self, x: &#vector, eps: #scalar) -> #scalar {
                #above
                #(#determinant)*
            }
        }
    });
    let rational_map = derived.rational_map.as_ref().map(|plan| emit_quotient(context, "rational_map", plan));
    let reduced_map = derived.reduced_map.as_ref().map(|plan| emit_quotient(context, "reduced_map", plan));
    quote! { #det_matrix #rational_map #reduced_map }
}

/// Expands to a function such as `rational_map`, which returns the numerators and the denominator.
fn emit_quotient(context: &Context<'_>, name: &str, plan: &Plan) -> TokenStream {
    let (bindings, mut numerators) = emit_body(context, plan);
    let denominator = numerators.pop();
    let (scalar, vector, name) = (&context.this.scalar, context.vector(), format_ident!("{name}"));
    quote! {
        fn #name(&self, x: &#vector, eps: #scalar) -> (#vector, #scalar) {
            #bindings
            (__kahan::vector([#(#numerators),*]), #denominator)
        }
    }
}
