//! Accessors of unconditional claims: `integrals`, `density`, `bracket_NAME`.

use kahan_algebra::plan::Plan;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::{Claim, upper_index};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::field::{emit_body, emit_vector};
use super::{Context, docs, items};

/// Expands to the accessors of all claims. Where there are no integrals, or no density, rustc is
/// told what a call lacks.
pub(super) fn emit_claims(context: &Context<'_>) -> TokenStream {
    let integrals = emit_integrals(context);
    let density = context.system.accessors(ClaimKind::Density).zip(&context.derived.density);
    let density = density.map(|(claim, plan)| emit_density(context, claim, plan));
    let brackets = context.system.accessors(ClaimKind::Bracket).zip(&context.derived.brackets);
    let brackets = brackets.map(|(claim, (_, plan))| emit_bracket(context, claim, plan));
    let this = context.self_type();
    let scalar = &context.scalar;
    let generics = if context.has_parameters() { quote!(<#scalar>) } else { quote!() };
    let lacks = |kind: ClaimKind, marker: TokenStream| {
        let is_lacking = context.system.accessors(kind).next().is_none();
        is_lacking.then(|| quote! { #[doc(hidden)] impl #generics __kahan::#marker for #this {} })
    };
    let lacking = [
        lacks(ClaimKind::Integral, quote!(WithoutIntegrals)),
        lacks(ClaimKind::Density, quote!(WithoutDensity)),
        context.has_parameters().then(|| {
            quote! { #[doc(hidden)] impl<#scalar: __kahan::Integer> __kahan::IntegerParameters for #this {} }
        }),
    ];
    quote! { #integrals #(#density)* #(#brackets)* #(#lacking)* }
}

/// `impl<T: Scalar> E7<T> { pub fn …(&self, …) }`, or `impl E6 { pub fn …<T: Scalar>(&self, …) }`.
fn emit_method(
    context: &Context<'_>,
    documentation: &TokenStream,
    name: &str,
    result: &TokenStream,
    body: &TokenStream,
) -> TokenStream {
    let (this, scalar, vector) = (context.self_type(), &context.scalar, context.vector());
    let name = format_ident!("{name}");
    let bounds = quote!(<#scalar: __kahan::Scalar>);
    let nothing = quote!();
    let (on_impl, on_method) =
        if context.has_parameters() { (&bounds, &nothing) } else { (&nothing, &bounds) };
    quote! {
        impl #on_impl #this {
            #documentation
            pub fn #name #on_method (&self, x: &#vector, eps: #scalar) -> #result {
                #body
            }
        }
    }
}

fn emit_integrals(context: &Context<'_>) -> TokenStream {
    let claims: Vec<&Claim> = context.system.accessors(ClaimKind::Integral).collect();
    if claims.is_empty() {
        return TokenStream::new();
    }
    let names = &context.derived.integral_names;
    let list = items::emit_list("INTEGRALS", "The names of the integrals, in order.", names);
    let (this, scalar, dimension) = (context.self_type(), &context.scalar, &context.dimension);
    let vector = context.vector();
    let count = Literal::usize_unsuffixed(claims.len());
    let result = quote!(__kahan::SVector<#scalar, #count>);
    let body = emit_vector(context, &context.derived.integrals);
    let method = emit_method(context, &docs::integrals(&claims), "integrals", &result, &body);
    let generics = if context.has_parameters() { quote!(<#scalar>) } else { quote!() };
    quote! {
        impl #generics #this {
            #list
        }
        #method
        impl<#scalar: __kahan::Scalar> __kahan::Integrals<#scalar, #dimension, #count> for #this {
            fn integral_names(&self) -> &'static [&'static __kahan::core::primitive::str] {
                &Self::INTEGRALS
            }
            fn integrals(&self, x: &#vector, eps: #scalar) -> #result {
                Self::integrals(self, x, eps)
            }
        }
    }
}

fn emit_density(context: &Context<'_>, claim: &Claim, plan: &Plan) -> TokenStream {
    let scalar = &context.scalar;
    let (bindings, results) = emit_body(context, plan);
    emit_method(context, &docs::density(claim), "density", &quote!(#scalar), &quote!(#bindings #(#results)*))
}

fn emit_bracket(context: &Context<'_>, claim: &Claim, plan: &Plan) -> TokenStream {
    let n = context.system.field.dimension();
    let (bindings, entries) = emit_body(context, plan);
    let upper: Vec<_> = (0..n).flat_map(|i| (i + 1..n).map(move |j| format_ident!("__p_{i}_{j}"))).collect();
    let rows = (0..n).map(|i| {
        let row = (0..n).map(|j| match i.cmp(&j) {
            std::cmp::Ordering::Equal => {
                let scalar = &context.scalar;
                quote!(__kahan::integer::<#scalar>(0))
            }
            std::cmp::Ordering::Less => {
                let entry = &upper[upper_index(n, i, j)];
                quote!(#entry.clone())
            }
            std::cmp::Ordering::Greater => {
                let entry = &upper[upper_index(n, j, i)];
                quote!(-#entry.clone())
            }
        });
        quote!([#(#row),*])
    });
    let body = quote! { #bindings #(let #upper = #entries;)* __kahan::matrix([#(#rows),*]) };
    let name = format!("bracket_{}", claim.name.text);
    emit_method(context, &docs::bracket(claim), &name, &context.matrix(), &body)
}
