//! Emits the quadratic field of a lifted block, and conversions between old and new states.

use kahan_algebra::arithmetic::Float64;
use kahan_algebra::check::{Broken, Checked, StandIn};
use kahan_algebra::diagnostics::{Diagnostic, Diagnostics, Kind};
use kahan_algebra::interpret::{Interpreter, Point};
use kahan_algebra::lexer::lex;
use kahan_algebra::parse::{parse, parse_lifted};
use kahan_algebra::plan::Node;
use kahan_algebra::prove::check_claims;
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_algebra::syntax::{
    Block, ClaimKind, Constant, Equation, FormulaSyntax, Header, Name, WrittenTokens,
};
use kahan_algebra::system::{Claim, System};
use kahan_algebra::token::{Span, Token};
use kahan_algebra::{check_unproved, seed};
use kahan_lift::{CalledFunction, Embedding, Input, Lift, Operation, Options, lift};
use proc_macro2::{Literal, Punct, Spacing, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::input_bindings::binding;
use super::items::{emit_name_list, identifier};
use super::{Context, docs};

/// The budget of the search for a lift. A larger budget would take too long in an unoptimised
/// macro.
const LIFT_SEARCH_BUDGET: usize = 200;

pub(super) struct Lifted {
    /// The number of original states, including the time `t` if `t` occurs in the equations.
    pub(super) states: usize,
    pub(super) lift: Option<Lift>,
    embedding: Embedding,
}

/// Lifts the equations of a block, and proves the block's claims for the lifted field.
pub(super) fn read(tokens: &[Token]) -> (Checked, Lifted) {
    let mut mistakes = Diagnostics::default();
    let block = parse_lifted(tokens, &mut mistakes);
    // The function `lift` reports these mistakes, too, so they are dropped here.
    drop(mistakes.finish());
    let place = block.header.as_ref().map_or(block.lift, |header| Some(header.name.span));
    let place = place.unwrap_or(Span::token(0));
    let lifted = lift(tokens, &Options { budget: LIFT_SEARCH_BUDGET, ..Options::default() });
    let lift = match lifted {
        Ok(lift) => lift,
        Err(mut diagnostics) => {
            diagnostics.iter_mut().for_each(|mistake| name_command(mistake, place));
            return placeholder_lift(block, diagnostics);
        }
    };
    let header = block.header.clone();
    let checked = match check_unproved(lifted_block(block, &lift, tokens, place)) {
        Checked::System(system) => with_proved_claims(System { header, ..system }, &lift, tokens),
        Checked::Broken(mut broken) => {
            broken.stand_in.header = header;
            Checked::Broken(broken)
        }
        family @ Checked::Family(_) => family,
    };
    let embedding = lift.embedding().clone();
    (checked, Lifted { states: lift.states.len(), lift: Some(lift), embedding })
}

/// Rewrites the error for an exhausted search budget, so that it suggests `kahan lift`.
fn name_command(mistake: &mut Diagnostic, place: Span) {
    if mistake.kind == Kind::TooLarge && mistake.span == Span::token(0) {
        mistake.span = place;
        mistake.message = "no quadratic lift was found within the limit of the macro".to_owned();
        mistake.help = "run `kahan lift --macro --file …` and write the block that it prints".to_owned();
    }
}

/// Returns a stand-in with the states of a block that could not be lifted.
fn placeholder_lift(block: Block<FormulaSyntax>, diagnostics: Vec<Diagnostic>) -> (Checked, Lifted) {
    let mut states: Vec<String> = Vec::new();
    for equation in block.equations {
        if !states.contains(&equation.state.text) {
            states.push(equation.state.text);
        }
    }
    let parameters = block.header.iter().flat_map(|header| &header.parameters).map(|name| name.text.clone());
    let symbols = Symbols { states, parameters: parameters.collect() };
    let states = symbols.states.len();
    let mut stand_in = StandIn::of_type(block.header);
    stand_in.symbols = symbols;
    let lifted = Lifted { states, lift: None, embedding: Embedding::default() };
    (Checked::Broken(Broken { diagnostics, stand_in }), lifted)
}

/// Returns the block with lifted equations. If the block has no header, the new header declares all
/// parameters, because some parameters may occur only in initial values.
fn lifted_block(block: Block<FormulaSyntax>, lift: &Lift, tokens: &[Token], place: Span) -> Block {
    let mut none = Diagnostics::default();
    let equations = parse(&lex(&lift.text()).tokens, &mut none).equations;
    assert!(none.finish().is_empty(), "a lift is written in the language of blocks");
    let own = |state: &str| block.equations.iter().find(|own| own.state.text == state);
    let equations = equations.into_iter().map(|equation| {
        let span = own(&equation.state.text).map_or(place, |own| own.state.span);
        Equation { state: Name { span, ..equation.state }, ..equation }
    });
    let constants = block.constants.iter().filter_map(|constant| {
        let value = Some(constant.value.as_ref()?.rational()?);
        Some(Constant { name: constant.name.clone(), value })
    });
    let header = block.header.clone().unwrap_or_else(|| {
        let named = |text: &String| {
            let first = tokens.iter().position(|token| token.text == *text);
            Name { text: text.clone(), span: first.map_or(place, Span::token) }
        };
        let parameters: Vec<Name> = lift.parameters.iter().map(named).collect();
        let described = vec![WrittenTokens::default(); parameters.len()];
        let name = Name { text: "Field".to_owned(), span: place };
        let [attributes, visibility] = [WrittenTokens::default(), WrittenTokens::default()];
        Header { attributes, visibility, name, parameters, described }
    });
    Block {
        header: Some(header),
        lift: block.lift.or(Some(place)),
        constants: constants.collect(),
        equations: equations.collect(),
        claims: block.claims,
        ..Block::default()
    }
}

/// Returns the system if its claims hold. Otherwise returns a stand-in and the mistakes.
fn with_proved_claims(system: System, lift: &Lift, tokens: &[Token]) -> Checked {
    let mut diagnostics = Diagnostics::default();
    check_claims(&system, seed(tokens), &mut diagnostics);
    let mut diagnostics = diagnostics.finish();
    if diagnostics.is_empty() {
        return Checked::System(system);
    }
    for mistake in diagnostics.iter_mut().filter(|mistake| mistake.kind == Kind::FalseClaim) {
        let claim = system.claims.iter().find(|claim| claim.name.span == mistake.span);
        if let Some(claim) = claim.filter(|claim| holds_on_relations(&system, claim, lift)) {
            let (kind, name) = (claim.kind.keyword(), &claim.name.text);
            mistake.message =
                format!("the {kind} `{name}` holds on the relations between the variables alone");
            mistake.help =
                "a claim of a lift is about its quadratic field, in which the new variables are free: \
                            write one that holds for all their values"
                    .to_owned();
        } else if let Some(energy) = &lift.energy {
            mistake.help =
                format!("eps is half the time step, and the energy that this map keeps is `{energy}`");
        }
    }
    let stand_in = StandIn::of_system(&system);
    Checked::Broken(Broken { diagnostics, stand_in })
}

/// Tests in floats whether an unproved integral is constant where the relations of the lift hold.
/// Steps from other points must change it at least 10⁹ times as much.
fn holds_on_relations(system: &System, claim: &Claim, lift: &Lift) -> bool {
    const EPS: f64 = 1.0 / 64.0;
    const ROUNDING: f64 = 1e-9;
    if claim.kind != ClaimKind::Integral || !claim.is_unconditional() {
        return false;
    }
    let symbols = &system.field.symbols;
    let interpreter = Interpreter::new(system);
    let change = |state: Vec<f64>, parameters: &[f64]| {
        let point = Point { state, parameters: parameters.to_vec(), eps: EPS };
        let next = interpreter.evaluate(&Float64, &point).ok()?.next?;
        let value = |state: &[f64]| {
            let input = |variable| match symbols.symbol(variable) {
                Symbol::State(i) | Symbol::SecondState(i) => state[i],
                Symbol::Parameter(k) => parameters[k],
                Symbol::Epsilon => EPS,
            };
            claim.plan.evaluate(&Float64, |read| read.variable().map(input)).pop()?
        };
        Some((value(&next)? - value(&point.state)?).abs()).filter(|change| change.is_finite())
    };
    let changes = (1..=6).filter_map(|place| {
        // States and parameters are between 0.3 and 0.8, where logarithms and similar are defined.
        let spread = |index: usize| 0.3 + ((7 + place) * (3 + index) % 11) as f64 / 20.0;
        let states: Vec<f64> = (0..lift.states.len()).map(spread).collect();
        let parameters: Vec<f64> = (0..lift.parameters.len()).map(|k| spread(k + states.len())).collect();
        let new = lift.embed(&states, &parameters);
        let beside = new.iter().enumerate().map(|(index, value)| value + spread(index));
        let on_relations = change([&states[..], &new].concat(), &parameters)?;
        Some((on_relations, change(states.iter().copied().chain(beside).collect(), &parameters)?))
    });
    let changes: Vec<(f64, f64)> = changes.collect();
    changes.len() > 2 && changes.iter().all(|&(on, beside)| on <= ROUNDING * beside)
}

impl Lifted {
    fn new_variables(&self) -> Vec<String> {
        self.lift.iter().flat_map(|lift| &lift.new).map(|new| new.name.clone()).collect()
    }
}

pub(super) const LISTS: [&str; 2] = ["NEW_VARIABLES", "RELATIONS"];

pub(super) fn emit_lists(lifted: &Lifted) -> TokenStream {
    let relations = lifted.lift.iter().flat_map(|lift| &lift.relations);
    let relations: Vec<String> = relations.map(|relation| relation.text.clone()).collect();
    let new = "The variables beyond the states, in order.";
    let new = emit_name_list(LISTS[0], new, &lifted.new_variables());
    let zero = "Relations between the variables: each is 0 at an embedded point.";
    let relations = emit_name_list(LISTS[1], zero, &relations);
    quote! { #new #relations }
}

/// Expands to `embed` and `project`. Trait bounds at the methods let rustc name an unsuitable
/// scalar type in its error.
pub(super) fn emit_methods(context: &Context<'_>, lifted: &Lifted) -> TokenStream {
    let (this, scalar) = (context.this.path(), &context.this.scalar);
    let (lifted_vector, count) = (context.vector(), Literal::usize_unsuffixed(lifted.states));
    let vector = quote!(__kahan::SVector<#scalar, #count>);
    let [embed, project] = [docs::embed(lifted), docs::project()]
        .map(|own| if context.is_proved { own } else { docs::placeholder_docs(false) });
    let first_values = emit_first_values(context, lifted);
    let of_type = context.this.generics();
    let generics = |bound: TokenStream| match of_type {
        Some(_) => (quote!(), quote!(where #scalar: #bound)),
        None => (quote!(<#scalar: #bound>), quote!()),
    };
    let (of_embed, where_embed) = generics(quote!(__kahan::EmbedScalar));
    let (of_project, where_project) = generics(quote!(__kahan::Scalar));
    quote! {
        impl #of_type #this {
            #embed
            pub fn embed #of_embed (&self, x: &#vector) -> #lifted_vector #where_embed {
                #first_values
            }
            #project
            pub fn project #of_project (&self, x: &#lifted_vector) -> #vector #where_project {
                __kahan::projected(x)
            }
        }
    }
}

/// Emits the body of `embed`. Each operation has a `let`, because its value may be used repeatedly.
fn emit_first_values(context: &Context<'_>, lifted: &Lifted) -> TokenStream {
    let symbols = &context.system.field.symbols;
    let program = &lifted.embedding.program;
    let mut used = vec![false; lifted.states];
    let mut bindings = TokenStream::new();
    let mut names: Vec<TokenStream> = Vec::new();
    for (index, operation) in program.operations.iter().enumerate() {
        let of = |place: &Node| &names[place.0];
        let infix = |a: &Node, operator: char, b: &Node| {
            let (a, b, operator) = (of(a), of(b), Punct::new(operator, Spacing::Alone));
            quote!(#a #operator #b)
        };
        let mut name = format_ident!("__e_{index}");
        let value = match operation {
            Operation::Input(Input::State(state)) => {
                used[*state] = true;
                names.push(binding(symbols, symbols.state(*state)).into_token_stream());
                continue;
            }
            Operation::Constant(value) => {
                names.push(emit_float(value.to_f64()));
                continue;
            }
            Operation::Input(Input::Parameter(parameter)) => {
                name = binding(symbols, symbols.parameter(*parameter));
                let field = identifier(&symbols.parameters[*parameter], proc_macro2::Span::call_site());
                quote!(__kahan::EmbedScalar::widened(self.#field))
            }
            Operation::Negate(a) => {
                let a = of(a);
                quote!(-#a)
            }
            Operation::Add(a, b) => infix(a, '+', b),
            Operation::Multiply(a, b) => infix(a, '*', b),
            Operation::Divide(a, b) => infix(a, '/', b),
            Operation::Call(called, a, b) => {
                let second = match called {
                    CalledFunction::Power(exponent) => {
                        Some(Literal::i32_unsuffixed(*exponent).into_token_stream())
                    }
                    CalledFunction::RealPower => Some(of(b).clone()),
                    _ => None,
                };
                let (function, a, second) = (format_ident!("{}", called.name()), of(a), second.into_iter());
                quote!(__kahan::elementary::#function(#a #(, #second)*))
            }
            _ => unreachable!("first values take one operation at a time"),
        };
        bindings.extend(quote! { let #name = #value; });
        names.push(name.into_token_stream());
    }
    let pattern = used.iter().enumerate().map(|(state, is_used)| {
        let name = binding(symbols, symbols.state(state));
        if *is_used { quote!(#name) } else { quote!(_) }
    });
    let states =
        used.contains(&true).then(|| quote! { let [#(#pattern),*] = __kahan::components_in_f64(x); });
    let values = program.outputs.iter().map(|value| &names[value.0]);
    quote! {
        #states
        #bindings
        __kahan::embedded(x, [#(#values),*])
    }
}

fn emit_float(value: f64) -> TokenStream {
    if value.is_finite() {
        let literal = Literal::f64_suffixed(value.abs());
        if value.is_sign_negative() { quote!((-#literal)) } else { quote!(#literal) }
    } else {
        let bits = Literal::u64_unsuffixed(value.to_bits());
        quote!(__kahan::f64::from_bits(#bits))
    }
}
