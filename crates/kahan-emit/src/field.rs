//! Emits `QuadraticField`: f, its Jacobian f′, the symmetric bilinear form and the polarised field.

use kahan_algebra::Derived;
use kahan_algebra::plan::Plan;
use proc_macro2::TokenStream;
use quote::quote;

use super::Context;
use super::coupled::{emit_parameters, table_sizes};
use super::input_bindings::emit_inputs;
use super::plan::{Emitted, emit_plan};

/// Expands to `impl<T: Scalar> QuadraticField<T, 3> for E6 { … }`.
pub(super) fn emit_field(context: &Context<'_>) -> TokenStream {
    let derived = context.derived.at_eps_zero();
    let (value, slope) = emit_value_and_slope(context, derived, &quote!(__kahan::integer(0)));
    let bilinear = emit_vector(context, derived.bilinear());
    // The polarised field of a homogeneous field is its bilinear form.
    let polarized = if derived.polarized() == derived.bilinear() {
        quote!(__kahan::QuadraticField::bilinear(self, x, y))
    } else {
        emit_vector(context, derived.polarized())
    };
    let (this, scalar, dimension) = (context.this.path(), &context.this.scalar, &context.dimension);
    let (vector, matrix) = (context.vector(), context.matrix());
    quote! {
        impl<#scalar: __kahan::Scalar> __kahan::QuadraticField<#scalar, #dimension> for #this {
            fn field(&self, x: &#vector) -> #vector {
                #value
            }
            fn field_jacobian(&self, x: &#vector) -> #matrix {
                #slope
            }
            fn bilinear(&self, x: &#vector, y: &#vector) -> #vector {
                #bilinear
            }
            fn polarized(&self, x: &#vector, y: &#vector) -> #vector {
                #polarized
            }
        }
    }
}

/// Expands to methods that evaluate the field at ε. Returns `None` if coefficients do not depend on
/// ε.
pub(super) fn emit_coefficients_of_eps(context: &Context<'_>) -> Option<TokenStream> {
    let derived = context.derived;
    if !context.system.field.depends_on_eps() {
        return None;
    }
    let (value, slope) = emit_value_and_slope(context, derived, &quote!(eps.clone()));
    let polarized = emit_vector(context, derived.polarized());
    let (scalar, vector, matrix) = (&context.this.scalar, context.vector(), context.matrix());
    Some(quote! {
        fn has_coefficients_of_eps(&self) -> __kahan::bool {
            true
        }
        fn field_at(&self, x: &#vector, eps: &#scalar) -> #vector {
            #value
        }
        fn field_jacobian_at(&self, x: &#vector, eps: &#scalar) -> #matrix {
            #slope
        }
        fn polarized_at(&self, x: &#vector, y: &#vector, eps: &#scalar) -> #vector {
            #polarized
        }
    })
}

/// Returns the bodies of `field` and `field_jacobian`.
fn emit_value_and_slope(
    context: &Context<'_>,
    derived: &Derived,
    eps: &TokenStream,
) -> (TokenStream, TokenStream) {
    let Some(couplings) = context.derived.couplings() else {
        return (emit_vector(context, derived.field()), emit_matrix(context, derived.field_jacobian()));
    };
    let (scalar, dimension) = (&context.this.scalar, &context.dimension);
    let own = emit_parameters(context, eps);
    let [parameters, slopes, places] = table_sizes(context, couplings);
    let field = quote!(__kahan::CoupledField<#dimension, #parameters, #slopes, #places>);
    let value = quote! {
        __kahan::vector(<__Coupled as #field>::field::<#scalar>(&#own, __kahan::components(x)))
    };
    let slope = quote! {
        __kahan::slopes_matrix::<__Coupled, #scalar, #dimension, #parameters, #slopes, #places>(
            <__Coupled as #field>::slopes(&#own, __kahan::components(x)),
        )
    };
    (value, slope)
}

pub(super) fn emit_vector(context: &Context<'_>, plan: &Plan) -> TokenStream {
    let (bindings, results) = emit_body(context, plan);
    quote! { #bindings __kahan::vector([#(#results),*]) }
}

fn emit_matrix(context: &Context<'_>, plan: &Plan) -> TokenStream {
    let (bindings, entries) = emit_body(context, plan);
    let rows = entries.chunks(context.system.field.dimension()).map(|row| quote!([#(#row),*]));
    quote! { #bindings __kahan::matrix([#(#rows),*]) }
}

pub(super) fn emit_body(context: &Context<'_>, plan: &Plan) -> (TokenStream, Vec<TokenStream>) {
    let symbols = &context.system.field.symbols;
    let inputs = emit_inputs(plan, symbols);
    let Emitted { bindings, results } = emit_plan(plan, symbols, &context.this.scalar);
    (quote! { #inputs #bindings }, results)
}
