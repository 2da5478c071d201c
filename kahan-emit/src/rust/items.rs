//! The type itself, its names, and the value of a block without a header.

use std::collections::BTreeMap;

use kahan_algebra::syntax::ClaimKind;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::tokens::Flat;

use super::Context;
use super::docs;
use super::header::{RustHeader, has_docs};

/// An identifier of the user's; `_` is what the front end has refused already.
pub(super) fn identifier(name: &str, span: Span) -> Ident {
    match syn::parse_str::<Ident>(name) {
        Ok(_) => Ident::new(name, span),
        Err(_) => Ident::new("refused_name", span),
    }
}

/// Expands to `#[derive(…)] pub struct E7<T> { pub xi: T }`, or `… struct E6;`.
pub(super) fn emit_struct(context: &Context<'_>, header: Option<&RustHeader>) -> TokenStream {
    let name = &context.name;
    let nothing = RustHeader::default();
    let header = header.unwrap_or(&nothing);
    let (attributes, visibility) = (&header.attributes, &header.visibility);
    let formulas = docs::system(context, has_docs(attributes));
    let derives = quote! {
        #[::core::prelude::v1::derive(
            ::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq
        )]
    };
    if !context.has_parameters() {
        return quote! { #(#attributes)* #formulas #derives #visibility struct #name; };
    }
    let fields = context.system.field.symbols.parameters.iter().map(|parameter| {
        let attributes = header.attributes_of(parameter);
        let field = identifier(parameter, Span::call_site());
        let docs = (!has_docs(attributes)).then(|| {
            let text = format!(" The parameter `{parameter}`.");
            quote!(#[doc = #text])
        });
        let scalar = &context.scalar;
        quote! { #(#attributes)* #docs pub #field: #scalar }
    });
    let scalar = &context.scalar;
    quote! { #(#attributes)* #formulas #derives #visibility struct #name<#scalar> { #(#fields),* } }
}

/// The lists that are constants of a type.
pub(super) const LISTS: [&str; 3] = ["VARIABLES", "PARAMETERS", "INTEGRALS"];

/// Expands to `impl E6 { pub const X: usize = 0; … }`, where each state stands in a point. Another
/// constant of the type, a second state or an integral of that name takes it from a state. Of
/// `E7<T>` one type has them, so that `E7::X` says all.
pub(super) fn emit_places(context: &Context<'_>) -> TokenStream {
    let (states, claims) = (&context.system.field.symbols.states, &context.system.claims);
    let names: Vec<String> = states.iter().map(|state| state.to_uppercase()).collect();
    let claimed = claims.iter().filter(|claim| claim.kind == ClaimKind::Integral);
    let others = claimed.map(|claim| claim.name.text.as_str()).chain(LISTS);
    let mut owners: BTreeMap<&str, usize> = BTreeMap::new();
    for name in names.iter().map(String::as_str).chain(others) {
        *owners.entry(name).or_default() += 1;
    }
    let places = states.iter().zip(&names).enumerate().filter_map(|(place, (state, name))| {
        let constant = syn::parse_str::<Ident>(name).ok().filter(|_| owners[name.as_str()] == 1)?;
        let documentation = format!(" Where `{state}` stands in a point: `x[{}::{name}]`.", context.name);
        let place = Literal::usize_unsuffixed(place);
        Some(quote! {
            #[doc = #documentation]
            pub const #constant: __kahan::usize = #place;
        })
    });
    let name = &context.name;
    let this = if context.has_parameters() { quote!(#name<__kahan::f64>) } else { quote!(#name) };
    quote! { impl #this { #(#places)* } }
}

/// Expands to `impl<T> Named for E7<T> { … }`, and what stands for it in the type itself: `pub
/// const VARIABLES …`.
pub(super) fn emit_names(context: &Context<'_>) -> (TokenStream, TokenStream) {
    let symbols = &context.system.field.symbols;
    let this = context.self_type();
    let scalar = &context.scalar;
    let generics = if context.has_parameters() { quote!(<#scalar>) } else { quote!() };
    let variables = emit_list("VARIABLES", "The state variables, in order.", &symbols.states);
    let parameters = emit_list("PARAMETERS", "The parameters, in order.", &symbols.parameters);
    let text = quote!(&'static [&'static __kahan::str]);
    let parameters_too = context.has_parameters().then(|| {
        quote! {
            fn parameters(&self) -> #text {
                &Self::PARAMETERS
            }
        }
    });
    let named = quote! {
        impl #generics __kahan::Named for #this {
            fn variables(&self) -> #text {
                &Self::VARIABLES
            }
            #parameters_too
        }
    };
    (named, quote! { #variables #parameters })
}

/// `pub const VARIABLES: [&'static str; 2] = ["x", "y"];`
pub(super) fn emit_list(constant: &str, documentation: &str, names: &[String]) -> TokenStream {
    let constant = Ident::new(constant, Span::call_site());
    let length = Literal::usize_unsuffixed(names.len());
    let documentation = format!(" {documentation}");
    quote! {
        #[doc = #documentation]
        pub const #constant: [&'static __kahan::str; #length] = [#(#names),*];
    }
}

/// Expands to `Field { mu: Clone::clone(&mu) }`: the value of a block without a header. The names
/// of the parameters are the user's own tokens, so that they mean what they mean there.
pub(super) fn emit_captured_value(context: &Context<'_>, input: &Flat) -> TokenStream {
    let name = &context.name;
    if !context.has_parameters() {
        return quote!(#name);
    }
    let parameters = context.system.field.symbols.parameters.iter();
    let fields = parameters.map(|parameter| emit_captured(parameter, input));
    quote!(#name { #(#fields),* })
}

/// `mu: Clone::clone(&mu)`, the second name from where the block has it.
pub(super) fn emit_captured(parameter: &str, input: &Flat) -> TokenStream {
    let field = identifier(parameter, Span::call_site());
    let place = input.tokens.iter().position(|token| token.text == parameter);
    let captured = identifier(parameter, place.map_or_else(Span::call_site, |place| input.spans[place]));
    quote!(#field: ::core::clone::Clone::clone(&#captured))
}
