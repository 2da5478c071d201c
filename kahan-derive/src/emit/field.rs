//! `QuadraticField`: f, f′, the bilinear form and the polarised field.

use kahan_algebra::kahan::{bilinear_form, field_jacobian, polarization};
use kahan_algebra::plan::{Plan, PlanBuilder};
use kahan_algebra::poly::Polynomial;
use proc_macro2::TokenStream;
use quote::quote;

use super::Context;
use super::inputs::emit_inputs;
use super::plan::emit_plan;

/// Expands to `impl<T: Scalar> QuadraticField<T, 3> for E6 { … }`.
pub(super) fn emit_field(context: &Context<'_>) -> TokenStream {
    let field = &context.system.field;
    let n = field.dimension();
    let numerators: Vec<Polynomial> =
        field.components.iter().map(|component| component.numerator.clone()).collect();
    let jacobian: Vec<Polynomial> = field_jacobian(field).into_iter().flatten().collect();
    let value = emit_vector(context, &over_denominators(context, &numerators, 1));
    let slope = emit_matrix(context, &over_denominators(context, &jacobian, n));
    let bilinear = emit_vector(context, &over_denominators(context, &bilinear_form(field), 1));
    let polarized = emit_vector(context, &over_denominators(context, &polarization(field), 1));
    let (this, scalar, dimension) = (context.self_type(), &context.scalar, &context.dimension);
    let (vector, matrix) = (context.vector(), context.matrix());
    quote! {
        impl<#scalar: __kahan::Scalar> __kahan::QuadraticField<#scalar, #dimension> for #this {
            fn field(&self, __state: &#vector) -> #vector {
                #value
            }
            fn field_jacobian(&self, __state: &#vector) -> #matrix {
                #slope
            }
            fn bilinear(&self, __state: &#vector, __other: &#vector) -> #vector {
                #bilinear
            }
            fn polarized(&self, __state: &#vector, __other: &#vector) -> #vector {
                #polarized
            }
        }
    }
}

/// The plan of these numerators, `width` of them over each component's denominator.
fn over_denominators(context: &Context<'_>, numerators: &[Polynomial], width: usize) -> Plan {
    let mut builder = PlanBuilder::default();
    let mut outputs = Vec::with_capacity(numerators.len());
    for (row, component) in numerators.chunks(width).zip(&context.system.field.components) {
        for numerator in row {
            let above = builder.polynomial(numerator);
            let below = builder.polynomial(&component.denominator);
            outputs.push(builder.divide(above, below));
        }
    }
    builder.finish(&outputs)
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
