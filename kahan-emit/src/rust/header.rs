//! The part of a header that only Rust understands: attributes, documentation, visibility.

use proc_macro2::TokenStream;
use syn::parse::{ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::{Attribute, Ident, Path, Token, Visibility, braced};

/// `attributes visibility struct Name { attributes param, … }` as Rust syntax.
#[derive(Default)]
pub(super) struct RustHeader {
    pub(super) attributes: Vec<Attribute>,
    pub(super) visibility: Option<Visibility>,
    pub(super) parameters: Vec<(Vec<Attribute>, Ident)>,
}

/// Reads the header of a block. What the front end has refused is left out here without a word.
pub(super) fn read(block: TokenStream) -> RustHeader {
    let mut header = RustHeader::default();
    let fill = |input: ParseStream<'_>| {
        let outcome = header.fill(input);
        // The rest of the block is the front end's.
        let _: TokenStream = input.parse()?;
        outcome
    };
    // An error here has been reported by the front end; what was understood before it is kept.
    let _: syn::Result<()> = fill.parse2(block);
    for attribute in &mut header.attributes {
        without_our_derives(attribute);
    }
    header
}

impl RustHeader {
    fn fill(&mut self, input: ParseStream<'_>) -> syn::Result<()> {
        self.attributes = Attribute::parse_outer(input)?;
        self.visibility = Some(input.parse()?);
        input.parse::<Token![struct]>()?;
        input.parse::<Ident>()?;
        if !input.peek(syn::token::Brace) {
            return Ok(());
        }
        let content;
        braced!(content in input);
        while !content.is_empty() {
            let attributes = Attribute::parse_outer(&content)?;
            let name = content.parse()?;
            self.parameters.push((attributes, name));
            if !content.is_empty() {
                content.parse::<Token![,]>()?;
            }
        }
        Ok(())
    }

    /// The user's attributes of the parameter `name`.
    pub(super) fn attributes_of(&self, name: &str) -> &[Attribute] {
        let found = self.parameters.iter().find(|(_, parameter)| parameter == name);
        found.map_or(&[], |(attributes, _)| attributes)
    }
}

/// Whether any of these attributes is documentation.
pub(super) fn has_docs(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| attribute.path().is_ident("doc"))
}

/// Takes the traits that the macro derives itself out of a `#[derive(…)]` of the user's.
fn without_our_derives(attribute: &mut Attribute) {
    const OURS: [&str; 4] = ["Clone", "Copy", "Debug", "PartialEq"];
    if !attribute.path().is_ident("derive") {
        return;
    }
    let Ok(list) = attribute.parse_args_with(Punctuated::<Path, Token![,]>::parse_terminated) else { return };
    let kept: Vec<Path> = list
        .into_iter()
        .filter(|path| {
            path.segments.last().is_none_or(|segment| !OURS.iter().any(|ours| segment.ident == ours))
        })
        .collect();
    *attribute = syn::parse_quote!(#[derive(#(#kept),*)]);
}
