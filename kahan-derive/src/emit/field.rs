//! `QuadraticField`: f, f′, the bilinear form and the polarised field.

use kahan_algebra::objects::{bilinear_plan, field_jacobian_plan, field_plan, polarized_plan};
use kahan_algebra::plan::Plan;
use proc_macro2::TokenStream;
use quote::quote;

use super::Context;
use super::inputs::emit_inputs;
use super::plan::emit_plan;

/// Expands to `impl<T: Scalar> QuadraticField<T, 3> for E6 { … }`.
pub(super) fn emit_field(context: &Context<'_>) -> TokenStream {
    let field = &context.system.field;
    let value = emit_vector(context, &field_plan(field));
    let slope = emit_matrix(context, &field_jacobian_plan(field));
    // Without a linear and a constant part the two forms are one.
    let (bilinear_plan, polarized_plan) = (bilinear_plan(field), polarized_plan(field));
    let polarized = if polarized_plan == bilinear_plan {
        quote!(__kahan::QuadraticField::bilinear(self, x, y))
    } else {
        emit_vector(context, &polarized_plan)
    };
    let bilinear = emit_vector(context, &bilinear_plan);
    let (this, scalar, dimension) = (context.self_type(), &context.scalar, &context.dimension);
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

/// The body of a function that returns the plan's results as a vector.
pub(super) fn emit_vector(context: &Context<'_>, plan: &Plan) -> TokenStream {
    let symbols = &context.system.field.symbols;
    let inputs = emit_inputs(plan, symbols);
    let emitted = emit_plan(plan, symbols, &context.scalar);
    let (bindings, results) = (emitted.bindings, emitted.results);
    quote! { #inputs #bindings __kahan::vector([#(#results),*]) }
}

/// The body of a function that returns the plan's results as a matrix, row by row.
fn emit_matrix(context: &Context<'_>, plan: &Plan) -> TokenStream {
    let symbols = &context.system.field.symbols;
    let inputs = emit_inputs(plan, symbols);
    let emitted = emit_plan(plan, symbols, &context.scalar);
    let bindings = emitted.bindings;
    let rows = emitted.results.chunks(symbols.dimension()).map(|row| quote!([#(#row),*]));
    quote! { #inputs #bindings __kahan::matrix([#(#rows),*]) }
}
