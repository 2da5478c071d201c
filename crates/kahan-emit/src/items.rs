//! Emits the generated type, its constants, and the value of a block without a header.

use std::collections::BTreeMap;

use kahan_algebra::syntax::{ClaimKind, Header};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::tokens::FlatTokens;

use super::Context;
use super::header::{RustHeader, has_docs};
use super::lifted;

/// Returns a name from the block as an identifier. A name that is no identifier, such as `_`, was
/// already reported as a mistake, and is replaced.
pub(super) fn identifier(name: &str, span: Span) -> Ident {
    match syn::parse_str::<Ident>(name) {
        Ok(_) => Ident::new(name, span),
        Err(_) => Ident::new("refused_name", span),
    }
}

/// The type that a block declares, which is anonymous without a header.
pub(super) struct Type<'a> {
    pub(super) name: Ident,
    pub(super) scalar: Ident,
    parameters: &'a [String],
    /// The parameters that have one value for each site of a family.
    site_parameters: &'a [String],
    header: Option<RustHeader>,
}

impl<'a> Type<'a> {
    pub(super) fn of(
        header: Option<&Header>,
        parameters: &'a [String],
        site_parameters: &'a [String],
        input: &FlatTokens,
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

    pub(super) fn path(&self) -> TokenStream {
        let (name, generics) = (&self.name, self.generics());
        quote!(#name #generics)
    }

    pub(super) fn generics(&self) -> Option<TokenStream> {
        let scalar = &self.scalar;
        self.has_parameters().then(|| quote!(<#scalar>))
    }

    /// Expands to `#[derive(…)] pub struct E7<T> { pub xi: T }`, or `… struct E6;`. `formulas`
    /// returns generated documentation. Its argument is true if the user's documentation precedes.
    pub(super) fn emit_definition(&self, formulas: impl FnOnce(bool) -> TokenStream) -> TokenStream {
        let (name, scalar) = (&self.name, &self.scalar);
        let nothing = RustHeader::default();
        let header = self.header.as_ref().unwrap_or(&nothing);
        let (attributes, visibility) = (&header.attributes, &header.visibility);
        let formulas = formulas(has_docs(attributes));
        // Site parameters are vectors, which are not `Copy`.
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

    /// Returns the items. If there is no header, returns a Rust block that ends with
    /// `Field { mu: Clone::clone(&mu) }`, where `mu` is a variable in the user's scope.
    pub(super) fn emit_items_or_block(&self, items: &TokenStream, input: &FlatTokens) -> TokenStream {
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

pub(super) const LISTS: [&str; 3] = ["VARIABLES", "PARAMETERS", "INTEGRALS"];

/// Expands to `impl E6 { pub const X: usize = 0; … }`, with the index of each state.
///
/// A state gets no constant if its name is already in use. A generic type such as `E7<T>` has the
/// constants only for `f64`, so that `E7::X` needs no type annotation.
pub(super) fn emit_state_indices(context: &Context<'_>) -> TokenStream {
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

/// Expands to `impl<T> Named for E7<T> { … }`, and to the constant `VARIABLES` of the type.
pub(super) fn emit_names(context: &Context<'_>) -> (TokenStream, TokenStream) {
    let symbols = &context.system.field.symbols;
    let (this, generics) = (context.this.path(), context.this.generics());
    let variables = emit_name_list("VARIABLES", "The state variables, in order.", &symbols.states);
    let parameters = emit_name_list("PARAMETERS", "The parameters, in order.", &symbols.parameters);
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

pub(super) fn emit_name_list(constant: &str, documentation: &str, names: &[String]) -> TokenStream {
    let constant = Ident::new(constant, Span::call_site());
    let length = Literal::usize_unsuffixed(names.len());
    let documentation = format!(" {documentation}");
    quote! {
        #[doc = #documentation]
        pub const #constant: [&'static __kahan::str; #length] = [#(#names),*];
    }
}
