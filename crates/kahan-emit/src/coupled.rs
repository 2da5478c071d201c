//! Emits a field of many variables: its entries, their positions in A(x,ε), and their elimination.
//!
//! ```text
//! pub struct __Coupled;
//! impl CoupledField<24, 0, 72, 114> for __Coupled {
//!     const COUPLINGS …; const FIELD …; const SLOPES …; const COST …;
//!     fn field(parameters, x) …; fn slopes(parameters, x) …; fn velocity(…) …
//! }
//! ```
//!
//! The size of the code grows with the numbers of nonzero entries of A(x,ε) and of elimination
//! steps.

use kahan_algebra::elimination::{Couplings, Row};
use kahan_algebra::plan::{Plan, variables};
use kahan_algebra::symbols::Symbol;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::Context;
use super::formulas::emit_formulas;
use super::input_bindings::emit_pattern;
use super::items::identifier;
use super::plan::{Emitted, emit_plan};
use super::step::emit_cost;

/// Emits the type `__Coupled`, which holds the formulas of a field and of its derivative.
pub(super) fn emit_coupled(context: &Context<'_>, couplings: &Couplings) -> TokenStream {
    let (scalar, dimension) = (&context.this.scalar, &context.dimension);
    let [parameters, slopes, places] = table_sizes(context, couplings);
    let (tables, cost) = (emit_tables(couplings), emit_cost(couplings.cost(context.derived.field())));
    let field = emit_entries(context, context.derived.field());
    let entries = emit_entries(context, &couplings.slopes);
    let table = |plan| emit_formulas(plan, &context.system.field.symbols);
    let [field_table, slopes_table] = [context.derived.field(), &couplings.slopes].map(table);
    let velocity = couplings.is_straight().then(|| emit_velocity(context, couplings));
    quote! {
        pub struct __Coupled;
        impl __kahan::CoupledField<#dimension, #parameters, #slopes, #places> for __Coupled {
            const COUPLINGS: __kahan::Couplings<'static> = #tables;
            const FIELD: &'static [__kahan::Postfix<'static>] = #field_table;
            const SLOPES: &'static [__kahan::Postfix<'static>] = #slopes_table;
            #cost
            fn field<#scalar: __kahan::Scalar>(
                __parameters: &[#scalar; #parameters],
                x: &[#scalar; #dimension],
            ) -> [#scalar; #dimension] {
                #field
            }
            fn slopes<#scalar: __kahan::Scalar>(
                __parameters: &[#scalar; #parameters],
                x: &[#scalar; #dimension],
            ) -> [#scalar; #slopes] {
                #entries
            }
            #velocity
        }
    }
}

/// Returns the numbers of parameters, of entries of f′, and of entries of A.
pub(super) fn table_sizes(context: &Context<'_>, couplings: &Couplings) -> [Literal; 3] {
    let sizes = [parameter_count(context), couplings.places.len(), couplings.columns.len()];
    sizes.map(Literal::usize_unsuffixed)
}

/// Returns the number of parameters, including ε if coefficients depend on ε.
fn parameter_count(context: &Context<'_>) -> usize {
    let field = &context.system.field;
    field.symbols.parameters.len() + usize::from(field.depends_on_eps())
}

/// Expands to `[self.mu.clone()]`. If coefficients depend on ε, `eps` comes last.
pub(super) fn emit_parameters(context: &Context<'_>, eps: &TokenStream) -> TokenStream {
    let eps = context.system.field.depends_on_eps().then_some(eps);
    let parameters = context.system.field.symbols.parameters.iter().map(|parameter| {
        let field = identifier(parameter, Span::call_site());
        quote!(self.#field.clone())
    });
    let parameters = parameters.chain(eps.cloned());
    quote!([#(#parameters),*])
}

/// The most operations in one function. A larger function would take longer to compile.
const MOST_OPERATIONS: usize = 160;

/// Emits the body of a function that returns the results of a plan. A long body is split.
fn emit_entries(context: &Context<'_>, plan: &Plan) -> TokenStream {
    if plan.operations.len() <= 2 * MOST_OPERATIONS {
        let (bindings, results) = emit_part(context, plan);
        return quote! { #bindings [#(#results),*] };
    }
    let (scalar, dimension) = (&context.this.scalar, &context.dimension);
    let parameters = Literal::usize_unsuffixed(parameter_count(context));
    let count = Literal::usize_unsuffixed(plan.outputs.len());
    let parts = plan.operations.len().div_ceil(MOST_OPERATIONS);
    let results = plan.outputs.len().div_ceil(parts);
    let parts = (0..plan.outputs.len()).step_by(results).map(|start| {
        let end = plan.outputs.len().min(start + results);
        let (bindings, results) = emit_part(context, &plan.part(start..end));
        let places = (start..).map(Literal::usize_unsuffixed);
        let lines =
            places.zip(results).map(|(place, result)| quote! { __kahan::put(&mut __out[#place], #result); });
        quote! {
            {
                #[inline(never)]
                fn part<#scalar: __kahan::Scalar>(
                    __parameters: &[#scalar; #parameters],
                    x: &[#scalar; #dimension],
                    __out: &mut [#scalar; #count],
                ) {
                    #bindings
                    #(#lines)*
                }
                part(__parameters, x, &mut __out);
            }
        }
    });
    quote! {
        let mut __out = __kahan::core::array::from_fn(|_| __kahan::integer(0));
        #(#parts)*
        __out
    }
}

fn emit_part(context: &Context<'_>, plan: &Plan) -> (TokenStream, Vec<TokenStream>) {
    let symbols = &context.system.field.symbols;
    let inputs = variables(plan);
    let states = emit_pattern(&inputs, symbols, Symbol::State, symbols.dimension());
    let states = states.map(|states| quote! { let #states = x; });
    let own = symbols.parameters.len();
    let parameter = |k| if k < own { Symbol::Parameter(k) } else { Symbol::Epsilon };
    let parameters = emit_pattern(&inputs, symbols, parameter, parameter_count(context));
    let parameters = parameters.map(|parameters| quote! { let #parameters = __parameters; });
    let Emitted { bindings, results } = emit_plan(plan, symbols, &context.this.scalar);
    (quote! { #states #parameters #bindings }, results)
}

fn emit_tables(couplings: &Couplings) -> TokenStream {
    let list = |numbers: &[usize]| {
        let numbers = numbers.iter().map(|number| Literal::usize_unsuffixed(*number));
        quote!(&[#(#numbers),*])
    };
    let Couplings { order, rows, columns, blocks, places, .. } = couplings;
    let rows = rows.iter().map(|&Row { start, own, diagonal, end }| {
        let [start, own, diagonal, end] = [start, own, diagonal, end].map(Literal::usize_unsuffixed);
        quote!(__kahan::CouplingRow::new(#start, #own, #diagonal, #end))
    });
    let [order, columns, blocks, places] = [order, columns, blocks, places].map(|numbers| list(numbers));
    quote! {
        __kahan::Couplings {
            order: #order,
            rows: &[#(#rows),*],
            columns: #columns,
            blocks: #blocks,
            places: #places,
        }
    }
}

/// Expands to `fn velocity(…) -> Option<[T; 24]> { … }`, which solves (I − εf′)v = f without loops.
fn emit_velocity(context: &Context<'_>, couplings: &Couplings) -> TokenStream {
    let (scalar, dimension) = (&context.this.scalar, &context.dimension);
    let [parameters, slopes, _] = table_sizes(context, couplings);
    let given = (0..couplings.places.len()).map(|k| format_ident!("__d{k}"));
    let right = (0..couplings.order.len()).map(|i| format_ident!("__b{i}"));
    let (filled, is_there) = emit_matrix_entries(couplings);
    let factors = emit_factors(couplings, is_there);
    let solution = emit_solution(couplings);
    let results = (0..couplings.order.len()).map(|i| format_ident!("__b{i}"));
    quote! {
        fn velocity<#scalar: __kahan::Scalar>(
            __parameters: &[#scalar; #parameters],
            x: &[#scalar; #dimension],
            eps: &#scalar,
        ) -> __kahan::Option<[#scalar; #dimension]> {
            let [#(#given),*]: [#scalar; #slopes] = Self::slopes(__parameters, x);
            let [__zero, __one]: [#scalar; 2] = [__kahan::integer(0), __kahan::integer(1)];
            #filled
            let __most: #scalar = __kahan::integer(__kahan::LARGEST_FACTOR);
            let mut __is_refused = false;
            #factors
            if __is_refused {
                return __kahan::None;
            }
            let [#(#right),*]: [#scalar; #dimension] = Self::field(__parameters, x);
            #solution
            __kahan::Some([#(#results),*])
        }
    }
}

fn entry_identifier(place: usize) -> Ident {
    format_ident!("__a{place}")
}

/// Emits the entries of A = I − εf′. Tells for each entry of L and U whether A has it, too.
fn emit_matrix_entries(couplings: &Couplings) -> (TokenStream, Vec<bool>) {
    let mut is_there = vec![false; couplings.columns.len()];
    let mut lines = TokenStream::new();
    for (k, &place) in couplings.places.iter().enumerate() {
        let (value, slope) = (entry_identifier(place), format_ident!("__d{k}"));
        lines.extend(quote! { let #value = -(eps.clone() * #slope); });
        is_there[place] = true;
    }
    for row in &couplings.rows {
        let diagonal = entry_identifier(row.diagonal);
        lines.extend(match is_there[row.diagonal] {
            true => quote! { let #diagonal = __one.clone() + #diagonal; },
            false => quote! { let #diagonal = __one.clone(); },
        });
        is_there[row.diagonal] = true;
    }
    (lines, is_there)
}

/// Emits the LU elimination, with multipliers below the diagonal and reciprocal pivots.
fn emit_factors(couplings: &Couplings, mut is_there: Vec<bool>) -> TokenStream {
    let Couplings { rows, columns, .. } = couplings;
    let mut lines = TokenStream::new();
    for row in rows {
        for left in row.own..row.diagonal {
            let above = &rows[columns[left]];
            let (factor, reciprocal) = (entry_identifier(left), entry_identifier(above.diagonal));
            let upper = (above.diagonal + 1..above.end).map(entry_identifier);
            lines.extend(quote! {
                let #factor = #factor * #reciprocal.clone();
                __is_refused |= #factor.is_better_pivot(&__most)
                    && (false #(|| (#upper.clone() * #reciprocal.clone()).is_better_pivot(&__most))*);
            });
            for upper in above.diagonal + 1..above.end {
                let place = (row.own..row.end).find(|&place| columns[place] == columns[upper]);
                let Some(place) = place else { unreachable!("what elimination fills in has a place") };
                let (value, upper) = (entry_identifier(place), entry_identifier(upper));
                let before = if is_there[place] { quote!(#value) } else { quote!(__zero.clone()) };
                lines.extend(quote! {
                    let #value = #before.subtract_product(#factor.clone(), #upper.clone());
                });
                is_there[place] = true;
            }
        }
        let pivot = entry_identifier(row.diagonal);
        lines.extend(quote! {
            __is_refused |= #pivot.is_zero();
            let #pivot = #pivot.reciprocal()?;
        });
    }
    lines
}

/// Emits the triangular substitutions, block by block. The solution replaces the right-hand side.
fn emit_solution(couplings: &Couplings) -> TokenStream {
    let Couplings { order, rows, columns, .. } = couplings;
    let right = |turn: usize| format_ident!("__b{}", order[turn]);
    let reduced = |start: TokenStream, places: &mut dyn Iterator<Item = usize>| {
        places.fold(start, |sum, place| {
            let (value, known) = (entry_identifier(place), right(columns[place]));
            quote!(#sum.subtract_product(#value.clone(), #known.clone()))
        })
    };
    let mut lines = TokenStream::new();
    let mut first = 0;
    for &end in &couplings.blocks {
        for turn in (first..end).filter(|&turn| rows[turn].start < rows[turn].diagonal) {
            let (row, own) = (&rows[turn], right(turn));
            let value = reduced(quote!(#own), &mut (row.start..row.diagonal));
            lines.extend(quote! { let #own = #value; });
        }
        for turn in (first..end).rev() {
            let (row, own, reciprocal) = (&rows[turn], right(turn), entry_identifier(rows[turn].diagonal));
            let value = reduced(quote!(#own), &mut (row.diagonal + 1..row.end).rev());
            lines.extend(quote! { let #own = #value * #reciprocal; });
        }
        first = end;
    }
    lines
}
