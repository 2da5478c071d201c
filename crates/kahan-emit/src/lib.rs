//! Emits Kahan's map of a system as Rust.
//!
//! `kahan-algebra` reads a block of the language of `kahan!`, and plans its operations. This crate
//! writes the map as tokens for the macro, or as formatted text. A block with a header expands to
//!
//! ```text
//! #[derive(Clone, Copy, Debug, PartialEq)] pub struct E7<T> { pub xi: T }
//! const _: () = {
//!     use kahan_core::__private as __kahan;
//!     impl<T> E7<T> { pub const VARIABLES: … }            // items
//!     impl<T: Scalar> QuadraticField<T, 3> for E7<T> { … }  // field
//!     pub struct __Step; impl Kernel<3, 2> for __Step { … } // step: the kernel for a state
//!     impl<T: Scalar> KahanMap<T, 3> for E7<T> { … }        // map
//!     impl<T: Scalar> E7<T> { fn integrals … }              // claims
//!     impl<T: EmbedScalar> E7<T> { fn embed … }             // lifted, if the block asks for it
//! };
//! ```
//!
//! A block without a header expands to
//! `{ …the items of an anonymous type…; Field { mu: mu.clone() } }`. Mistakes become
//! `compile_error!`, usually next to a stand-in type, which prevents further errors.
//!
//! Generated code names items of `kahan-core` through `__kahan`. Bindings, except arguments such as
//! `eps`, have the prefix `__`: state `x` is `__s_x`, and parameter `mu` is `__p_mu`. Without the
//! prefix, a constant of the user with an equal name would be taken for a pattern.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod claims;
mod coupled;
mod docs;
mod family;
mod field;
mod formulas;
mod header;
mod input_bindings;
mod items;
mod lifted;
mod map;
mod names;
mod number;
mod plan;
mod step;
#[cfg(feature = "text")]
mod text;
mod tokens;

use std::fs;
use std::path::{Path, PathBuf};

use kahan_algebra::check::{Broken, Checked, StandIn};
use kahan_algebra::diagnostics::Diagnostic;
use kahan_algebra::elimination::{too_many_couplings, too_many_parameters};
use kahan_algebra::parse::asks_for_lift;
use kahan_algebra::render::report;
use kahan_algebra::syntax::Header;
use kahan_algebra::system::System;
use kahan_algebra::token::Span;
use kahan_algebra::{Derived, derive};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use syn::LitStr;

use tokens::{FlatTokens, Source};

use claims::EmittedClaims;
use items::Type;
use lifted::Lifted;
#[cfg(feature = "text")]
pub use text::{ExpansionTextError, text};

struct Context<'a> {
    system: &'a System,
    derived: &'a Derived,
    this: Type<'a>,
    lifted: Option<&'a Lifted>,
    dimension: Literal,
    /// Whether the claims are proved. If not, the code is a stand-in for a block with mistakes.
    is_proved: bool,
}

/// The expansion of a block.
#[derive(Debug)]
pub struct Expansion {
    /// The name of the system.
    pub name: String,
    /// The code of the expansion.
    pub tokens: TokenStream,
}

/// Expands a block, given by the tokens between the brackets of `kahan!`. `core` is the path of the
/// crate that contains `__private`. Mistakes become `compile_error!` at their tokens.
#[must_use]
pub fn expand(core: &TokenStream, block: TokenStream) -> Expansion {
    let input = tokens::flatten(block);
    let block = read_block(&input);
    Expansion { name: type_name(block.checked.header()), tokens: emit(core, block, &input) }
}

struct ParsedBlock {
    checked: Checked,
    lifted: Option<Lifted>,
}

fn read_block(input: &FlatTokens) -> ParsedBlock {
    if asks_for_lift(&input.tokens) {
        let (checked, lifted) = lifted::read(&input.tokens);
        return ParsedBlock { checked, lifted: Some(lifted) };
    }
    ParsedBlock { checked: kahan_algebra::read(&input.tokens), lifted: None }
}

/// Expands the block in a file, like `include_kahan!("FILE")`. `file` is the literal, and `beside`
/// is the source file that contains the literal. A change of the file makes the compiler expand the
/// block again.
///
/// Mistakes become one `compile_error!` at the literal, which marks each position with a caret.
#[must_use]
pub fn include(core: &TokenStream, file: TokenStream, beside: Option<&Path>) -> Expansion {
    try_include(core, file, beside)
        .unwrap_or_else(|error| Expansion { name: "nothing".to_owned(), tokens: error.to_compile_error() })
}

fn try_include(core: &TokenStream, file: TokenStream, beside: Option<&Path>) -> syn::Result<Expansion> {
    const WANTED: &str =
        "the path of a file is wanted\nhelp: write a literal, `include_kahan!(\"toda.kahan\")`";
    let literal: LitStr = syn::parse2(file).map_err(|error| syn::Error::new(error.span(), WANTED))?;
    let (origin, span) = (literal.value(), literal.span());
    let path =
        beside.and_then(Path::parent).map_or_else(|| PathBuf::from(&origin), |folder| folder.join(&origin));
    #[expect(clippy::disallowed_methods, reason = "the compiler's user names the file")]
    let read = fs::canonicalize(&path).and_then(|path| Ok((fs::read_to_string(&path)?, path)));
    let (text, path) = read.map_err(|error| {
        let help = "a path is relative to the file that `include_kahan!` stands in";
        syn::Error::new(span, format!("`{}` cannot be read: {error}\nhelp: {help}", path.display()))
    })?;
    let input = tokens::of_text(text, origin, span);
    let block = read_block(&input);
    let path = path.to_string_lossy();
    let watched = quote!(
        const _: &[::core::primitive::u8] = ::core::include_bytes!(#path);
    );
    let header = block.checked.header();
    let (name, is_item) = (type_name(header), header.is_some());
    let emitted = emit(core, block, &input);
    let tokens = if is_item { quote!(#watched #emitted) } else { quote!({ #watched #emitted }) };
    Ok(Expansion { name, tokens })
}

fn type_name(header: Option<&Header>) -> String {
    header.map_or("field", |header| header.name.text.as_str()).to_owned()
}

fn emit(core: &TokenStream, block: ParsedBlock, input: &FlatTokens) -> TokenStream {
    let ParsedBlock { checked, lifted } = block;
    let lifted = lifted.as_ref();
    let place = checked.header().map_or(Span::token(0), |header| header.name.span);
    let mistake = match &checked {
        Checked::System(system) => too_many_parameters(system.field.symbols.parameters.len(), place)
            .or_else(|| too_many_couplings(&system.field, place)),
        Checked::Family(family) => {
            too_many_parameters(family.parameters.len() + family.site_parameters.len(), place)
        }
        Checked::Broken(Broken { stand_in, .. }) => {
            too_many_parameters(stand_in.symbols.parameters.len() + stand_in.site_parameters.len(), place)
        }
    };
    if let Some(mistake) = mistake {
        let stand_in = StandIn::of_type(checked.header().cloned());
        let diagnostics = [&[mistake], checked.diagnostics()].concat();
        return emit_broken(core, &Broken { diagnostics, stand_in }, lifted, input);
    }
    match checked {
        Checked::System(system) => emit_system(core, &derive(&system), lifted, input, true),
        Checked::Family(family) => family::emit_family(core, &family, input),
        Checked::Broken(broken) => emit_broken(core, &broken, lifted, input),
    }
}

/// Emits the errors of a block, and a stand-in type whose methods return 0. If the states are
/// unknown, the type has no methods, or is omitted if the block has no header.
fn emit_broken(
    core: &TokenStream,
    broken: &Broken,
    lifted: Option<&Lifted>,
    input: &FlatTokens,
) -> TokenStream {
    let Broken { diagnostics, stand_in } = broken;
    let errors = emit_errors(diagnostics, input);
    let StandIn { header, symbols, site_parameters, .. } = stand_in;
    if symbols.dimension() > 0 {
        let emitted = emit_system(core, &derive(&stand_in.system()), lifted, input, false);
        return if header.is_some() {
            quote! { #errors #emitted }
        } else {
            quote! { { #errors #emitted } }
        };
    }
    if header.is_none() {
        // A single `compile_error!` is an item and an expression, but several need a block.
        return if diagnostics.len() <= 1 {
            errors
        } else {
            quote! { { #errors } }
        };
    }
    let this = Type::of(header.as_ref(), &symbols.parameters, site_parameters, input);
    let definition = this.emit_definition(docs::placeholder_docs);
    quote! { #errors #definition }
}

/// Emits the type of a system and its implementations. If there is no header, also emits a value of
/// the type.
fn emit_system(
    core: &TokenStream,
    derived: &Derived,
    lifted: Option<&Lifted>,
    input: &FlatTokens,
    is_proved: bool,
) -> TokenStream {
    let system = &derived.system;
    let this = Type::of(system.header.as_ref(), &system.field.symbols.parameters, &[], input);
    let dimension = Literal::usize_unsuffixed(system.field.dimension());
    let context = Context { system, derived, this, lifted, dimension, is_proved };
    let definition = context.this.emit_definition(|follows| docs::system(&context, follows));
    let implementations = emit_implementations(core, &context);
    context.this.emit_items_or_block(&quote! { #definition #implementations }, input)
}

fn emit_implementations(core: &TokenStream, context: &Context<'_>) -> TokenStream {
    let (named, names) = items::emit_names(context);
    let places = context.system.header.as_ref().map(|_| items::emit_state_indices(context));
    let field = field::emit_field(context);
    let map = map::emit_map(context);
    let EmittedClaims { constants, methods, implementations } = claims::emit_claims(context);
    let lists = context.lifted.map(lifted::emit_lists);
    let embedding = context.lifted.map(|lifted| lifted::emit_methods(context, lifted));
    let (this, scalar) = (context.this.path(), &context.this.scalar);
    let inherent = if context.this.has_parameters() {
        let methods =
            (!methods.is_empty()).then(|| quote! { impl<#scalar: __kahan::Scalar> #this { #methods } });
        quote! { impl<#scalar> #this { #names #lists #constants } #methods }
    } else {
        quote! { impl #this { #names #lists #constants #methods } }
    };
    quote! {
        #[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
        #[allow(non_snake_case, non_upper_case_globals, unused, missing_docs)]
        const _: () = {
            use #core::__private::{self as __kahan, arguments::*, Clone as _};
            #inherent
            #embedding
            #places
            #named
            #field
            #map
            #implementations
        };
    }
}

/// Emits a `compile_error!` at each mistake, or one for all mistakes of an included file.
fn emit_errors(diagnostics: &[Diagnostic], input: &FlatTokens) -> TokenStream {
    let spans = &input.spans;
    if let (Some(Source { text, ranges, origin }), false) = (&input.source, diagnostics.is_empty()) {
        let reports = diagnostics.iter().map(|diagnostic| report(diagnostic, text, ranges, origin));
        let reports = format!("in the file that is included:\n\n{}", reports.collect::<Vec<_>>().join("\n"));
        let place = spans.first().copied().unwrap_or_else(proc_macro2::Span::call_site);
        return syn::Error::new(place, reports.trim_end()).to_compile_error();
    }
    let at = |index: usize| {
        spans.get(index).or(spans.last()).copied().unwrap_or_else(proc_macro2::Span::call_site)
    };
    diagnostics
        .iter()
        .map(|diagnostic| {
            // syn marks all tokens from the first to the last, so the error needs only two spans.
            let first = Ident::new("first", at(diagnostic.span.first));
            let last = Ident::new("last", at(diagnostic.span.last));
            syn::Error::new_spanned(quote! { #first #last }, diagnostic).to_compile_error()
        })
        .collect()
}

impl Context<'_> {
    fn vector(&self) -> TokenStream {
        let (scalar, n) = (&self.this.scalar, &self.dimension);
        quote!(__kahan::SVector<#scalar, #n>)
    }

    fn matrix(&self) -> TokenStream {
        let (scalar, n) = (&self.this.scalar, &self.dimension);
        quote!(__kahan::SMatrix<#scalar, #n, #n>)
    }
}
