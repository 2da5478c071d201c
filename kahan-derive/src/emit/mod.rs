//! A read block to Rust.
//!
//! With a header it expands to
//!
//! ```text
//! #[derive(Clone, Copy, Debug, PartialEq)] pub struct E7<T> { pub xi: T }
//! const _: () = {
//!     use kahan_core::__private as __kahan;
//!     impl<T> E7<T> { pub const VARIABLES: … }            // items
//!     impl<T: Scalar> QuadraticField<T, 3> for E7<T> { … }  // field
//!     pub struct __Step; impl Kernel<3, 2> for __Step { … } // step: what a state runs through
//!     impl<T: Scalar> KahanMap<T, 3> for E7<T> { … }        // map
//!     impl<T: Scalar> E7<T> { fn integrals … }              // claims
//! };
//! ```
//!
//! and without one to `{ …the same with an anonymous type…; Field { mu: mu.clone() } }`. Mistakes become
//! `compile_error!` beside all of that, so that code which uses the type stays quiet.
//!
//! Names: everything of ours is reached through `__kahan`, and bindings begin with `__` (a state
//! `x` is `__s_x`, a parameter `mu` is `__p_mu`): a constant or a unit struct of the user's in
//! scope would capture a pattern of its name. Only arguments, which rustdoc shows, have names for
//! reading; a function of each name is imported, which hides the user's, and a pattern may have the name
//! of a function.

mod claims;
mod docs;
mod field;
mod header;
mod inputs;
mod items;
mod map;
mod names;
mod number;
mod plan;
mod step;

use kahan_algebra::Reading;
use kahan_algebra::diagnostics::Diagnostic;
use kahan_algebra::kahan::RationalMap;
use kahan_algebra::plan::StepPlan;
use kahan_algebra::system::System;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use crate::tokens::Flat;

use claims::EmittedClaims;
use header::RustHeader;

/// What every part of the emitter reads.
struct Context<'a> {
    system: &'a System,
    /// The map in closed form, within the budget.
    map: Option<RationalMap>,
    /// The step as a plan; `None` where it is elimination.
    step: Option<StepPlan>,
    /// The type's name.
    name: Ident,
    /// The scalar type parameter, named so that it is not the type's name.
    scalar: Ident,
    /// The dimension as a literal.
    dimension: Literal,
}

/// Emits a block: its compiler tokens, what the front end read, and the tokens that it read.
pub(crate) fn emit(core: &TokenStream, block: TokenStream, reading: &Reading, input: &Flat) -> TokenStream {
    let spans = &input.spans;
    let header = reading.system.header.as_ref().map(|_| header::read(block));
    let errors = emit_errors(&reading.diagnostics, spans);
    if reading.system.field.dimension() == 0 {
        return emit_without_field(reading, header.as_ref(), spans, &errors);
    }
    let context = Context::of(&reading.system, spans);
    let definition = items::emit_struct(&context, header.as_ref());
    let implementations = emit_implementations(core, &context);
    if header.is_some() {
        return quote! { #errors #definition #implementations };
    }
    let value = items::emit_captured_value(&context, input);
    quote! { { #errors #definition #implementations #value } }
}

fn emit_implementations(core: &TokenStream, context: &Context<'_>) -> TokenStream {
    let (named, names) = items::emit_names(context);
    let field = field::emit_field(context);
    let map = map::emit_map(context);
    let EmittedClaims { constants, methods, implementations } = claims::emit_claims(context);
    let (this, scalar) = (context.self_type(), &context.scalar);
    let inherent = if context.has_parameters() {
        let methods =
            (!methods.is_empty()).then(|| quote! { impl<#scalar: __kahan::Scalar> #this { #methods } });
        quote! { impl<#scalar> #this { #names #constants } #methods }
    } else {
        quote! { impl #this { #names #constants #methods } }
    };
    quote! {
        #[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
        #[allow(non_snake_case, non_upper_case_globals, unused, missing_docs)]
        const _: () = {
            use #core::__private::{self as __kahan, arguments::*, Clone as _};
            #inherent
            #named
            #field
            #map
            #implementations
        };
    }
}

/// A block without a single equation: its errors, and its type if it has a header.
fn emit_without_field(
    reading: &Reading,
    header: Option<&RustHeader>,
    spans: &[Span],
    errors: &TokenStream,
) -> TokenStream {
    if header.is_none() {
        // A single `compile_error!` is right as an item and as an expression; there is no telling which is wanted.
        return if reading.diagnostics.len() == 1 {
            errors.clone()
        } else {
            quote! { { #errors } }
        };
    }
    let definition = items::emit_struct(&Context::of(&reading.system, spans), header);
    quote! { #errors #definition }
}

/// One `compile_error!` a mistake, over its tokens.
fn emit_errors(diagnostics: &[Diagnostic], spans: &[Span]) -> TokenStream {
    let at = |index: usize| spans.get(index).or(spans.last()).copied().unwrap_or_else(Span::call_site);
    diagnostics
        .iter()
        .map(|diagnostic| {
            // Two tokens carry the first and the last place; syn spans the error over both.
            let first = Ident::new("first", at(diagnostic.span.first));
            let last = Ident::new("last", at(diagnostic.span.last));
            syn::Error::new_spanned(quote! { #first #last }, diagnostic).to_compile_error()
        })
        .collect()
}

impl<'a> Context<'a> {
    fn of(system: &'a System, spans: &[Span]) -> Self {
        let name = match &system.header {
            Some(header) => {
                let span = spans.get(header.name.span.first).copied().unwrap_or_else(Span::call_site);
                items::identifier(&header.name.text, span)
            }
            None => format_ident!("Field"),
        };
        let scalar = if name == "T" { format_ident!("S") } else { format_ident!("T") };
        let dimension = Literal::usize_unsuffixed(system.field.dimension());
        let map = RationalMap::of(&system.field);
        let step = StepPlan::of_map(&system.field, map.as_ref());
        Context { system, map, step, name, scalar, dimension }
    }

    fn has_parameters(&self) -> bool {
        !self.system.field.symbols.parameters.is_empty()
    }

    /// `E7<T>`, or `E6` where there are no parameters.
    fn self_type(&self) -> TokenStream {
        let (name, scalar) = (&self.name, &self.scalar);
        if self.has_parameters() { quote!(#name<#scalar>) } else { quote!(#name) }
    }

    /// `__kahan::SVector<T, 3>`
    fn vector(&self) -> TokenStream {
        let (scalar, n) = (&self.scalar, &self.dimension);
        quote!(__kahan::SVector<#scalar, #n>)
    }

    /// `__kahan::SMatrix<T, 3, 3>`
    fn matrix(&self) -> TokenStream {
        let (scalar, n) = (&self.scalar, &self.dimension);
        quote!(__kahan::SMatrix<#scalar, #n, #n>)
    }
}
