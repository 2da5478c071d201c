//! A family to Rust: the straight lines of one site, and the sums it claims.
//!
//! ```text
//! pub struct Volterra;
//! const _: () = {
//!     use kahan_core::__private as __kahan;
//!     impl<T: Scalar> Family<T> for Volterra { type Shape = Stencil<…>; fn field …; fn rows … }
//!     impl<T: Scalar> Sums<T> for Volterra { … }          // what is claimed
//! };
//! ```

use kahan_algebra::family::{Family, Lines};
use kahan_algebra::plan::Plan;
use kahan_algebra::render::expression_text;
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_algebra::syntax::Boundary;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::docs::stand_in;
use super::header::{RustHeader, has_docs};
use super::inputs::binding;
use super::items::identifier;
use super::plan::{Emitted, emit_kernel, emit_plan};
use super::tokens::Flat;

struct Context<'a> {
    family: &'a Family,
    lines: Lines,
    name: Ident,
    /// The scalar of the values, and that of the lines.
    scalar: Ident,
    line_scalar: Ident,
    /// Whether the block has no mistake, so that its claims are proved.
    is_sound: bool,
}

/// The type of a family, its implementations, and for a block without a header its value.
pub(super) fn emit_family(
    core: &TokenStream,
    family: &Family,
    header: Option<&RustHeader>,
    input: &Flat,
    errors: &TokenStream,
) -> TokenStream {
    let place = family.header.as_ref().and_then(|header| input.spans.get(header.name.span.first));
    let name = identifier(
        if family.header.is_some() { family.name() } else { "Field" },
        place.copied().unwrap_or_else(Span::call_site),
    );
    let [scalar, line_scalar] = match name.to_string().as_str() {
        "T" => ["S", "L"],
        "L" => ["T", "S"],
        _ => ["T", "L"],
    };
    let (scalar, line_scalar) = (format_ident!("{scalar}"), format_ident!("{line_scalar}"));
    let is_sound = errors.is_empty();
    let context = Context { family, lines: family.lines(), name, scalar, line_scalar, is_sound };
    let definition = context.emit_struct(header);
    // What is broken has a type, and nothing that steps.
    let implementations = family.is_sound.then(|| context.emit_implementations(core));
    if family.header.is_some() {
        return quote! { #errors #definition #implementations };
    }
    let value = context.emit_value(input);
    quote! { { #errors #definition #implementations #value } }
}

impl Context<'_> {
    fn has_parameters(&self) -> bool {
        !self.family.parameters.is_empty() || !self.family.site_parameters.is_empty()
    }

    fn self_type(&self) -> TokenStream {
        let (name, scalar) = (&self.name, &self.scalar);
        if self.has_parameters() { quote!(#name<#scalar>) } else { quote!(#name) }
    }

    fn emit_struct(&self, header: Option<&RustHeader>) -> TokenStream {
        let name = &self.name;
        let nothing = RustHeader::default();
        let header = header.unwrap_or(&nothing);
        let (attributes, visibility) = (&header.attributes, &header.visibility);
        let formulas = self.documentation(has_docs(attributes));
        // Values of sites stand in vectors, which are cloned.
        let copy = self.family.site_parameters.is_empty().then(|| quote!(::core::marker::Copy,));
        let derives = quote! {
            #[::core::prelude::v1::derive(
                ::core::clone::Clone, #copy ::core::fmt::Debug, ::core::cmp::PartialEq
            )]
        };
        if !self.has_parameters() {
            return quote! { #(#attributes)* #formulas #derives #visibility struct #name; };
        }
        let scalar = &self.scalar;
        let field = |name: &String, what: &str, of: TokenStream| {
            let attributes = header.attributes_of(name);
            let text = format!(" The parameter `{name}`{what}.");
            let docs = (!has_docs(attributes)).then(|| quote!(#[doc = #text]));
            let field = identifier(name, Span::call_site());
            quote! { #(#attributes)* #docs pub #field: #of }
        };
        let of_chain = self.family.parameters.iter().map(|name| field(name, "", quote!(#scalar)));
        let vector = quote!(::std::vec::Vec<#scalar>);
        let of_sites =
            self.family.site_parameters.iter().map(|name| field(name, ", one value a site", vector.clone()));
        let fields = of_chain.chain(of_sites);
        quote! { #(#attributes)* #formulas #derives #visibility struct #name<#scalar> { #(#fields),* } }
    }

    /// The equations and what is proved, as formulas.
    fn documentation(&self, follows: bool) -> TokenStream {
        if !self.is_sound {
            return stand_in(follows);
        }
        let family = self.family;
        let chain = match family.boundary {
            Boundary::Periodic => "closed to a ring",
            Boundary::Open => "open: states beyond its ends are 0",
        };
        let mut lines = vec![
            format!(
                " Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for a chain of any number of sites, {chain}:"
            ),
            String::new(),
            " ```text".to_owned(),
        ];
        lines.extend(family.equations().map(|line| format!(" {line}")));
        lines.push(" ```".to_owned());
        let claims: Vec<String> = family
            .integrals
            .iter()
            .map(|sum| ("integral", sum))
            .chain(family.hamiltonian.iter().map(|sum| ("hamiltonian", sum)))
            .map(|(word, sum)| format!(" {word} {} = {}", sum.name.text, expression_text(&sum.written)))
            .collect();
        if !claims.is_empty() {
            lines.extend([
                String::new(),
                " Proved while compiling, for every number of sites:".to_owned(),
                String::new(),
                " ```text".to_owned(),
            ]);
            lines.extend(claims);
            lines.push(" ```".to_owned());
        }
        if follows {
            lines.insert(0, String::new());
        }
        lines.iter().map(|line| quote!(#[doc = #line])).collect()
    }

    fn emit_implementations(&self, core: &TokenStream) -> TokenStream {
        let (this, scalar) = (self.self_type(), &self.scalar);
        let (family, lines) = (self.family, &self.lines);
        let (arrays, site_parameters) = (&family.arrays, &family.site_parameters);
        let boundary = match family.boundary {
            Boundary::Periodic => quote!(Periodic),
            Boundary::Open => quote!(Open),
        };
        let shape = [
            family.block(),
            family.reach,
            site_parameters.len(),
            lines.constants.outputs.len(),
            lines.lower,
            lines.upper,
            family.stencil(),
            lines.lower + 1 + lines.upper,
        ]
        .map(Literal::usize_unsuffixed);
        let constants = self.emit_constants();
        let site_parameter = self.emit_site_parameter();
        let b = family.block();
        let field = self.emit_line("field", &lines.field, &[("f", (0..b).collect())]);
        let columns = family.stencil() * b;
        let entries = lines.entries.iter().map(|place| place.row * columns + place.column);
        let rows = self.emit_line("rows", &lines.rows, &[("f", (0..b).collect()), ("a", entries.collect())]);
        let sums = self.emit_sums();
        let text = quote!(&'static [&'static __kahan::str]);
        quote! {
            #[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
            #[allow(non_snake_case, non_upper_case_globals, unused, missing_docs)]
            const _: () = {
                use #core::__private::{self as __kahan, arguments::*, Clone as _};
                impl<#scalar: __kahan::LatticeScalar> __kahan::Family<#scalar> for #this {
                    type Shape = __kahan::Stencil<#(#shape),*>;
                    const ARRAYS: #text = &[#(#arrays),*];
                    const SITE_PARAMETERS: #text = &[#(#site_parameters),*];
                    const BOUNDARY: __kahan::Boundary = __kahan::Boundary::#boundary;
                    #constants
                    #site_parameter
                    #field
                    #rows
                }
                #sums
            };
        }
    }

    fn emit_constants(&self) -> TokenStream {
        let (lines, line_scalar, scalar) = (&self.lines, &self.line_scalar, &self.scalar);
        let inputs = lines.constants.inputs();
        let parameters = lines.given.parameters.iter().enumerate();
        let bindings: TokenStream = parameters
            .filter(|(k, _)| inputs.contains(&lines.given.parameter(*k)))
            .map(|(k, name)| {
                let (binding, field) =
                    (binding(&lines.given, lines.given.parameter(k)), identifier(name, Span::call_site()));
                quote! { let #binding = lift(&self.#field); }
            })
            .collect();
        let Emitted { bindings: steps, results } =
            emit_kernel(&lines.constants, &lines.given, line_scalar, &[], false);
        quote! {
            fn constants<#line_scalar: __kahan::Scalar>(
                &self,
                eps: #line_scalar,
                lift: impl __kahan::Fn(&#scalar) -> #line_scalar,
            ) -> __kahan::Option<__kahan::Vec<#line_scalar>> {
                #bindings
                #steps
                __kahan::Some(__kahan::Vec::from([#(#results),*]))
            }
        }
    }

    fn emit_site_parameter(&self) -> TokenStream {
        let scalar = &self.scalar;
        let arms = self.family.site_parameters.iter().enumerate().map(|(k, name)| {
            let (k, field) = (Literal::usize_unsuffixed(k), identifier(name, Span::call_site()));
            quote! { #k => &self.#field, }
        });
        quote! {
            fn site_parameter(&self, index: usize) -> &[#scalar] {
                match index {
                    #(#arms)*
                    _ => &[],
                }
            }
        }
    }

    /// Expands to `fn field<L: Scalar>(constants: &[L], x: &[L], c: &[L], f: &mut [L]) { … }`: the
    /// results of a plan, written to these places of these slices.
    fn emit_line(&self, name: &str, plan: &Plan, results_at: &[(&str, Vec<usize>)]) -> TokenStream {
        let (name, scalar) = (format_ident!("{name}"), &self.line_scalar);
        let inputs = self.emit_inputs(plan, &self.lines.symbols);
        let Emitted { bindings, results } = emit_plan(plan, &self.lines.symbols, scalar);
        let slices = results_at.iter().map(|(slice, _)| format_ident!("{slice}"));
        let places = results_at.iter().flat_map(|(slice, places)| {
            places.iter().map(move |place| (format_ident!("{slice}"), Literal::usize_unsuffixed(*place)))
        });
        let writes = places.zip(results).map(|((slice, place), result)| quote! { #slice[#place] = #result; });
        quote! {
            #[inline(always)]
            fn #name<#scalar: __kahan::Scalar>(
                constants: &[#scalar],
                x: &[#scalar],
                c: &[#scalar],
                #(#slices: &mut [#scalar]),*
            ) {
                #inputs
                #bindings
                #(#writes)*
            }
        }
    }

    /// What a line reads, bound to names.
    fn emit_inputs(&self, plan: &Plan, symbols: &Symbols) -> TokenStream {
        let values = self.family.symbols.states.len();
        let (stencil, parameters) = (self.family.stencil(), self.family.site_parameters.len());
        plan.inputs()
            .into_iter()
            .map(|variable| {
                let name = binding(symbols, variable);
                let at = |slice: &str, place: usize| {
                    let (slice, place) = (format_ident!("{slice}"), Literal::usize_unsuffixed(place));
                    quote! { let #name = &#slice[#place]; }
                };
                match symbols.symbol(variable) {
                    Symbol::State(k) if k < values => at("x", k),
                    Symbol::State(k) => {
                        let (index, site) = ((k - values) / stencil, (k - values) % stencil);
                        at("c", site * parameters + index)
                    }
                    Symbol::Parameter(k) => at("constants", k),
                    Symbol::Epsilon | Symbol::SecondState(_) => TokenStream::new(),
                }
            })
            .collect()
    }

    /// Expands to `impl<T: Scalar> Sums<T> for Volterra { … }` where sums are claimed.
    fn emit_sums(&self) -> Option<TokenStream> {
        let family = self.family;
        let count = family.sums().count();
        if count == 0 {
            return None;
        }
        let (this, scalar) = (self.self_type(), &self.scalar);
        let integrals = family.integrals.iter().map(|sum| &sum.name.text);
        let line = self.emit_line("densities", &self.lines.sums, &[("s", (0..count).collect())]);
        let energy = family.hamiltonian.as_ref().map(|sum| {
            let name = &sum.name.text;
            quote! {
                impl<#scalar: __kahan::LatticeScalar> __kahan::Energy<#scalar> for #this {
                    const HAMILTONIAN: &'static __kahan::str = #name;
                }
            }
        });
        Some(quote! {
            impl<#scalar: __kahan::LatticeScalar> __kahan::Sums<#scalar> for #this {
                const INTEGRALS: &'static [&'static __kahan::str] = &[#(#integrals),*];
                #line
            }
            #energy
        })
    }

    /// Expands to `Field { mu: Clone::clone(&mu) }`: the value of a block without a header.
    fn emit_value(&self, input: &Flat) -> TokenStream {
        let name = &self.name;
        if !self.has_parameters() {
            return quote!(#name);
        }
        let parameters = self.family.parameters.iter().chain(&self.family.site_parameters);
        let fields = parameters.map(|parameter| super::items::emit_captured(parameter, input));
        quote!(#name { #(#fields),* })
    }
}
