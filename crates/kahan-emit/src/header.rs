//! Turns the attributes, documentation and visibility of a header into Rust syntax.

use std::collections::BTreeMap;

use kahan_algebra::syntax::Header;
use proc_macro2::TokenStream;
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::{Attribute, Path, Token};

use super::tokens::FlatTokens;

#[derive(Default)]
pub(super) struct RustHeader {
    pub(super) attributes: Vec<Attribute>,
    pub(super) visibility: TokenStream,
    parameters: BTreeMap<String, Vec<Attribute>>,
}

impl RustHeader {
    /// Parses a header. Invalid attributes are left out, because the front end has reported them.
    pub(super) fn of(header: &Header, input: &FlatTokens) -> Self {
        let attributes = |written| Attribute::parse_outer.parse2(input.rust(written)).unwrap_or_default();
        let described = header.described.iter().map(attributes);
        let names = header.parameters.iter().map(|name| name.text.clone());
        let mut own = attributes(&header.attributes);
        own.iter_mut().for_each(without_our_derives);
        Self {
            attributes: own,
            visibility: input.rust(&header.visibility),
            parameters: names.zip(described).collect(),
        }
    }

    pub(super) fn attributes_of(&self, name: &str) -> &[Attribute] {
        self.parameters.get(name).map_or(&[], Vec::as_slice)
    }
}

pub(super) fn has_docs(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| attribute.path().is_ident("doc"))
}

/// Removes from the user's `#[derive(…)]` the traits that the macro itself derives.
fn without_our_derives(attribute: &mut Attribute) {
    const DERIVED_TRAITS: [&str; 4] = ["Clone", "Copy", "Debug", "PartialEq"];
    if !attribute.path().is_ident("derive") {
        return;
    }
    let Ok(list) = attribute.parse_args_with(Punctuated::<Path, Token![,]>::parse_terminated) else { return };
    let kept: Vec<Path> = list
        .into_iter()
        .filter(|path| {
            path.segments
                .last()
                .is_none_or(|segment| !DERIVED_TRAITS.iter().any(|ours| segment.ident == ours))
        })
        .collect();
    *attribute = syn::parse_quote!(#[derive(#(#kept),*)]);
}
