//! Emits a family as Rust: the plans of one site, and the densities of claimed sums.
//!
//! ```text
//! pub struct Volterra;
//! const _: () = {
//!     use kahan_core::__private as __kahan;
//!     impl<T: Scalar> LatticeMap<T> for Volterra { const ARRAYS … fn rows … fn densities … }
//! };
//! ```

use kahan_algebra::derived::Lines;
use kahan_algebra::family::Family;
use kahan_algebra::plan::{Plan, variables};
use kahan_algebra::render::expression_text;
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_algebra::syntax::Boundary;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::input_bindings::{binding, emit_bound_parameters};
use super::items::{Type, identifier};
use super::plan::{Emitted, emit_kernel, emit_plan};
use super::tokens::FlatTokens;

struct Context<'a> {
    family: &'a Family,
    lines: Lines,
    this: Type<'a>,
    /// The name of the scalar type of emitted functions. The parameters may have another type.
    line_scalar: Ident,
}

/// Emits the type of a family and its implementations. If there is no header, also emits a value of
/// the type.
pub(super) fn emit_family(core: &TokenStream, family: &Family, input: &FlatTokens) -> TokenStream {
    let this = Type::of(family.header.as_ref(), &family.parameters, &family.site_parameters, input);
    let line_scalar = format_ident!("{}", if this.name == "L" { "S" } else { "L" });
    let context = Context { family, lines: family.lines(), this, line_scalar };
    let definition = context.this.emit_definition(|follows| context.documentation(follows));
    let implementations = context.emit_implementations(core);
    context.this.emit_items_or_block(&quote! { #definition #implementations }, input)
}

impl Context<'_> {
    fn documentation(&self, follows: bool) -> TokenStream {
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
        let (this, scalar) = (self.this.path(), &self.this.scalar);
        let (family, lines) = (self.family, &self.lines);
        let (arrays, site_parameters) = (&family.arrays, &family.site_parameters);
        let reach = Literal::usize_unsuffixed(family.reach);
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
        let columns = family.stencil() * b;
        let entries = lines.entries.iter().map(|place| place.row * columns + place.column);
        let rows = self.emit_line("rows", &lines.rows, &[("f", (0..b).collect()), ("a", entries.collect())]);
        let sums = self.emit_sums();
        let text = quote!(&'static [&'static __kahan::str]);
        let names = (!site_parameters.is_empty())
            .then(|| quote! { const SITE_PARAMETERS: #text = &[#(#site_parameters),*]; });
        quote! {
            #[allow(clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
            #[allow(non_snake_case, non_upper_case_globals, unused, missing_docs)]
            const _: () = {
                use #core::__private::{self as __kahan, arguments::*, Clone as _};
                impl<#scalar: __kahan::LatticeScalar> __kahan::LatticeMap<#scalar> for #this {
                    const ARRAYS: #text = &[#(#arrays),*];
                    const REACH: __kahan::usize = #reach;
                    #names
                    type Kernels = __kahan::Stencil<#(#shape),*>;
                    fn sizes(&self) -> __kahan::Sizes {
                        Self::Kernels::SIZES
                    }
                    fn boundary(&self) -> __kahan::Boundary {
                        __kahan::Boundary::#boundary
                    }
                    #constants
                    #site_parameter
                    #rows
                    #sums
                }
            };
        }
    }

    fn emit_constants(&self) -> TokenStream {
        let (lines, line_scalar, scalar) = (&self.lines, &self.line_scalar, &self.this.scalar);
        let inputs = variables(&lines.constants);
        let bindings = emit_bound_parameters(&inputs, &lines.given, |field| quote!(convert(&self.#field)));
        let Emitted { bindings: steps, results } =
            emit_kernel(&lines.constants, &lines.given, line_scalar, &[], false);
        quote! {
            fn constants<#line_scalar: __kahan::Scalar>(
                &self,
                eps: #line_scalar,
                convert: impl __kahan::Fn(&#scalar) -> #line_scalar,
            ) -> __kahan::Option<__kahan::Vec<#line_scalar>> {
                #bindings
                #steps
                __kahan::Some(__kahan::Vec::from([#(#results),*]))
            }
        }
    }

    fn emit_site_parameter(&self) -> Option<TokenStream> {
        if self.family.site_parameters.is_empty() {
            return None;
        }
        let scalar = &self.this.scalar;
        let arms = self.family.site_parameters.iter().enumerate().map(|(k, name)| {
            let (k, field) = (Literal::usize_unsuffixed(k), identifier(name, Span::call_site()));
            quote! { #k => &self.#field, }
        });
        Some(quote! {
            fn site_parameter(&self, index: usize) -> &[#scalar] {
                match index {
                    #(#arms)*
                    _ => &[],
                }
            }
        })
    }

    /// Expands to a function that evaluates a plan, and stores the results in slices:
    /// `fn rows<L: Scalar>(&self, constants: &[L], x: &[L], c: &[L], _: &mut [L], …) { … }`.
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
                &self,
                constants: &[#scalar],
                x: &[#scalar],
                c: &[#scalar],
                _: &mut [#scalar],
                #(#slices: &mut [#scalar]),*
            ) {
                #inputs
                #bindings
                #(#writes)*
            }
        }
    }

    fn emit_inputs(&self, plan: &Plan, symbols: &Symbols) -> TokenStream {
        let values = self.family.symbols.states.len();
        let (stencil, parameters) = (self.family.stencil(), self.family.site_parameters.len());
        variables(plan)
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

    fn emit_sums(&self) -> Option<TokenStream> {
        let family = self.family;
        let count = family.sums().count();
        if count == 0 {
            return None;
        }
        let integrals = family.integrals.iter().map(|sum| &sum.name.text);
        let line = self.emit_line("densities", &self.lines.sums, &[("s", (0..count).collect())]);
        let energy = family.hamiltonian.as_ref().map(|sum| {
            let name = &sum.name.text;
            quote! {
                const HAMILTONIAN: __kahan::Option<&'static __kahan::str> = __kahan::Some(#name);
            }
        });
        Some(quote! {
            const INTEGRALS: &'static [&'static __kahan::str] = &[#(#integrals),*];
            #energy
            #line
        })
    }
}
