//! The type itself, its names, and the value of a block without a header.

use std::collections::BTreeMap;

use kahan_algebra::syntax::{ClaimKind, Header};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::tokens::Flat;

use super::Context;
use super::header::{RustHeader, has_docs};
use super::lifted;

/// An identifier of the user's; `_` is what the front end has refused already.
pub(super) fn identifier(name: &str, span: Span) -> Ident {
    match syn::parse_str::<Ident>(name) {
        Ok(_) => Ident::new(name, span),
        Err(_) => Ident::new("refused_name", span),
    }
}

/// The type that a block declares, or the anonymous one of a block without a header.
pub(super) struct Type<'a> {
    pub(super) name: Ident,
    /// The scalar type parameter, named so that it is not the type's name.
    pub(super) scalar: Ident,
    parameters: &'a [String],
    /// The parameters that each site of a family has.
    site_parameters: &'a [String],
    header: Option<RustHeader>,
}

impl<'a> Type<'a> {
    pub(super) fn of(
        header: Option<&Header>,
        parameters: &'a [String],
        site_parameters: &'a [String],
        input: &Flat,
    ) -> Self {
        let name = header.map_or_else(
            || Ident::new("Field", Span::call_site()),
            |header| {
                let place = input.spans.get(header.name.span.first).copied();
                identifier(&header.name.text, place.unwrap_or_else(Span::call_site))
            },
        );
        let scalar = Ident::new(if name == "T" { "S" } else { "T" }, Span::call_site());
        let header = header.map(|header| RustHeader::of(header, input));
        Type { name, scalar, parameters, site_parameters, header }
    }

    pub(super) fn has_parameters(&self) -> bool {
        !self.parameters.is_empty() || !self.site_parameters.is_empty()
    }

    /// `E7<T>`, or `E6` where there are no parameters.
    pub(super) fn path(&self) -> TokenStream {
        let (name, generics) = (&self.name, self.generics());
        quote!(#name #generics)
    }

    /// `<T>` behind an `impl` for the type, or nothing where there are no parameters.
    pub(super) fn generics(&self) -> Option<TokenStream> {
        let scalar = &self.scalar;
        self.has_parameters().then(|| quote!(<#scalar>))
    }

    /// Expands to `#[derive(…)] pub struct E7<T> { pub xi: T }`, or `… struct E6;`. `formulas` is
    /// told whether the user's own documentation comes first.
    pub(super) fn emit_definition(&self, formulas: impl FnOnce(bool) -> TokenStream) -> TokenStream {
        let (name, scalar) = (&self.name, &self.scalar);
        let nothing = RustHeader::default();
        let header = self.header.as_ref().unwrap_or(&nothing);
        let (attributes, visibility) = (&header.attributes, &header.visibility);
        let formulas = formulas(has_docs(attributes));
        // Values of sites stand in vectors, which are cloned.
        let copy = self.site_parameters.is_empty().then(|| quote!(::core::marker::Copy,));
        let derives = quote! {
            #[::core::prelude::v1::derive(
                ::core::clone::Clone, #copy ::core::fmt::Debug, ::core::cmp::PartialEq
            )]
        };
        if !self.has_parameters() {
            return quote! { #(#attributes)* #formulas #derives #visibility struct #name; };
        }
        let field = |parameter: &String, what: &str, of: &TokenStream| {
            let attributes = header.attributes_of(parameter);
            let text = format!(" The parameter `{parameter}`{what}.");
            let docs = (!has_docs(attributes)).then(|| quote!(#[doc = #text]));
            let field = identifier(parameter, Span::call_site());
            quote! { #(#attributes)* #docs pub #field: #of }
        };
        let (one, vector) = (quote!(#scalar), quote!(::std::vec::Vec<#scalar>));
        let of_all = self.parameters.iter().map(|name| field(name, "", &one));
        let of_sites = self.site_parameters.iter().map(|name| field(name, ", one value a site", &vector));
        let fields = of_all.chain(of_sites);
        quote! { #(#attributes)* #formulas #derives #visibility struct #name<#scalar> { #(#fields),* } }
    }

    /// The definition with its implementations and what rustc is to report; a block without a
    /// header has a value, `Field { mu: Clone::clone(&mu) }`, and the names of the parameters in it
    /// are the user's own tokens, so that they mean what they mean there.
    pub(super) fn emit_with(&self, items: &TokenStream, input: &Flat) -> TokenStream {
        if self.header.is_some() {
            return items.clone();
        }
        let name = &self.name;
        let mut spans: BTreeMap<&str, Span> = BTreeMap::new();
        for (token, span) in input.tokens.iter().zip(&input.spans) {
            spans.entry(&token.text).or_insert(*span);
        }
        let captured = |parameter: &String| {
            let field = identifier(parameter, Span::call_site());
            let span = spans.get(parameter.as_str()).copied();
            let captured = identifier(parameter, span.unwrap_or_else(Span::call_site));
            quote!(#field: ::core::clone::Clone::clone(&#captured))
        };
        let fields = self.parameters.iter().chain(self.site_parameters).map(captured);
        let value = if self.has_parameters() { quote!(#name { #(#fields),* }) } else { quote!(#name) };
        quote! { { #items #value } }
    }
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
    let lists = context.lifted.iter().flat_map(|_| lifted::LISTS).chain(LISTS);
    let others = claimed.map(|claim| claim.name.text.as_str()).chain(lists);
    let mut owners: BTreeMap<&str, usize> = BTreeMap::new();
    for name in names.iter().map(String::as_str).chain(others) {
        *owners.entry(name).or_default() += 1;
    }
    let places = states.iter().zip(&names).enumerate().filter_map(|(place, (state, name))| {
        let constant = syn::parse_str::<Ident>(name).ok().filter(|_| owners[name.as_str()] == 1)?;
        let documentation =
            format!(" Where `{state}` stands in a point: `x[{}::{name}]`.", context.this.name);
        let place = Literal::usize_unsuffixed(place);
        Some(quote! {
            #[doc = #documentation]
            pub const #constant: __kahan::usize = #place;
        })
    });
    let name = &context.this.name;
    let this = if context.this.has_parameters() { quote!(#name<__kahan::f64>) } else { quote!(#name) };
    quote! { impl #this { #(#places)* } }
}

/// Expands to `impl<T> Named for E7<T> { … }`, and what stands for it in the type itself: `pub
/// const VARIABLES …`.
pub(super) fn emit_names(context: &Context<'_>) -> (TokenStream, TokenStream) {
    let symbols = &context.system.field.symbols;
    let (this, generics) = (context.this.path(), context.this.generics());
    let variables = emit_list("VARIABLES", "The state variables, in order.", &symbols.states);
    let parameters = emit_list("PARAMETERS", "The parameters, in order.", &symbols.parameters);
    let text = quote!(&'static [&'static __kahan::str]);
    let parameters_too = context.this.has_parameters().then(|| {
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
