//! Writes the documentation of the generated items, including their formulas.

use kahan_algebra::plan::LARGEST_SIZE;
use kahan_algebra::render::{
    Formulas, Text, claim_statement, claim_text, condition_note, condition_text, expression_text, folded,
};
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::Claim;
use kahan_lift::Lift;
use proc_macro2::TokenStream;
use quote::quote;

use super::Context;
use super::lifted::Lifted;

/// The largest length of a formula in bytes. Longer formulas are shown only by `kahan show`.
const MAX_FORMULA_BYTES: usize = 2_000;

fn emit_lines(lines: &[String]) -> TokenStream {
    lines.iter().map(|line| quote!(#[doc = #line])).collect()
}

pub(super) fn placeholder_docs(follows: bool) -> TokenStream {
    let line = " The block has mistakes, which the compiler reports. This stands in for what it would be, \
                and nothing that the block claims is proved.";
    let before = follows.then(|| quote!(#[doc = ""]));
    quote!(#before #[doc = #line])
}

/// Writes the documentation of a system. `follows` says whether documentation by the user comes
/// before it.
pub(super) fn system(context: &Context<'_>, follows: bool) -> TokenStream {
    if !context.is_proved {
        return placeholder_docs(follows);
    }
    let system = context.system;
    let states = &system.field.symbols.states;
    let formulas = Formulas { field: &system.field, map: context.derived.map.as_ref(), notation: &Text };
    let mut lines = Vec::new();
    if follows {
        lines.push(String::new());
    }
    let which = if context.lifted.is_some() { "quadratic lift" } else { "field" };
    lines.push(format!(
        " Kahan's method, x ↦ x̃ with time step 2ε (`eps` is ε, half the time step), for the {which}"
    ));
    lines.push(String::new());
    let constants = system.constants.iter().map(|(name, value)| format!("const {name} = {value}"));
    let written = system.written.iter().map(expression_text);
    let equations = states.iter().zip(written).map(|(state, value)| format!("{state}dot = {value}"));
    push_formulas(&mut lines, &constants.chain(equations).collect::<Vec<_>>());
    if let Some(lift) = context.lifted.and_then(|lifted| lifted.lift.as_ref()) {
        push_lift(&mut lines, lift);
    }
    push_block(&mut lines, "Matrix A(x,ε) = I − ε f′(x), row by row:", &formula_rows(&formulas));
    match formulas.map() {
        Some(map) => {
            let images: Vec<String> =
                states.iter().zip(map).map(|(state, image)| format!("{state}~ = {image}")).collect();
            push_block(&mut lines, "The map, over its common denominator in lowest terms:", &images);
        }
        None => lines.push(
            " The map solves A(x,ε)·x̃ = b(x,ε): its closed form exceeds the budget of terms. Where det A = 0 it counts as a pole.".to_owned(),
        ),
    }
    if let Some(step) = context.derived.step() {
        lines.extend(step_size_note("`step` and orbits keep", step.holds_to));
        let general = step.general.as_ref().filter(|general| general.holds_to < step.holds_to);
        let of_lanes = "Ensembles, and scalars other than `f32` and `f64`, keep";
        lines.extend(general.into_iter().flat_map(|general| step_size_note(of_lanes, general.holds_to)));
    }
    let claims: Vec<String> =
        system.claims.iter().map(|claim| claim_with_conditions(context, claim)).collect();
    if !claims.is_empty() {
        push_block(&mut lines, "Proved while compiling:", &claims);
    }
    emit_lines(&lines)
}

/// Appends the new variables of a lift, their relations, and the energy that the map conserves.
fn push_lift(lines: &mut Vec<String>, lift: &Lift) {
    let title = format!("Reason for this lift: {}. Its new variables:", lift.chosen);
    let new = lift.new.iter().map(|new| {
        let expression = new.expression.as_deref().unwrap_or("the work done since the start, 0 there");
        format!("{} = {expression}", new.name)
    });
    push_block(lines, &title, &new.collect::<Vec<_>>());
    let relations = lift.relations.iter().map(|relation| match &relation.formula {
        Some(formula) => format!("{} = 0  // the map keeps {formula}", relation.text),
        None => format!("{} = 0", relation.text),
    });
    let relations: Vec<String> = relations.collect();
    if !relations.is_empty() {
        push_block(lines, "Relations, which hold at embedded points:", &relations);
    }
    for note in &lift.notes {
        lines.extend([String::new(), format!(" {note}")]);
    }
    if !lift.is_optimal {
        let text = "The macro did not prove that no other lift is smaller; `kahan lift --macro` searches for longer.";
        lines.extend([String::new(), format!(" {text}")]);
    }
    if let Some(energy) = &lift.energy {
        push_block(lines, "The energy that the map keeps exactly:", std::slice::from_ref(energy));
    }
}

pub(super) fn embed(lifted: &Lifted) -> TokenStream {
    let mut lines = vec![
        " The point of the lift that belongs to the states `x`, with first values of the new variables."
            .to_owned(),
    ];
    if lifted.lift.as_ref().is_some_and(|lift| lift.has_time) {
        lines.push(" The last of the states is the time `t`.".to_owned());
    }
    let how =
        " They are computed in `f64`, by functions of the crate `libm`, and have the same bits everywhere.";
    lines.extend([String::new(), how.to_owned()]);
    emit_lines(&lines)
}

pub(super) fn project() -> TokenStream {
    emit_lines(&[" The states of a point of the lift.".to_owned()])
}

/// Returns the text of a claim, with the divisors that must be nonzero.
fn claim_with_conditions(context: &Context<'_>, claim: &Claim) -> String {
    let note = condition_note(context.system, claim);
    let text = claim_text(context.system, claim);
    if note.is_empty() { text } else { format!("{text}  // {note}") }
}

/// Writes a paragraph if steps are accurate only up to the norm ‖ε f′‖∞ = `holds_to`.
fn step_size_note(who: &str, holds_to: u32) -> Vec<String> {
    if holds_to == LARGEST_SIZE {
        return Vec::new();
    }
    vec![
        String::new(),
        format!(
            " {who} the digits that elimination with pivoting keeps (a median error of at most 30 times its, or 300 u) while \
             ‖ε f′(x)‖∞ ≤ {holds_to}, as measured by the planner. Longer steps lose more; `try_step` promises what it returns."
        ),
    ]
}

fn formula_rows(formulas: &Formulas<'_>) -> Vec<String> {
    formulas.matrix().iter().map(|row| format!("[ {} ]", row.join(", "))).collect()
}

fn push_block(lines: &mut Vec<String>, title: &str, text: &[String]) {
    if text.iter().map(String::len).sum::<usize>() > MAX_FORMULA_BYTES {
        return;
    }
    lines.extend([String::new(), format!(" {title}"), String::new()]);
    push_formulas(lines, text);
}

fn push_formulas(lines: &mut Vec<String>, formulas: &[String]) {
    /// The approximate number of characters in a line that rustdoc shows without a scroll bar.
    const WIDTH: usize = 96;
    let folded = formulas.iter().map(|formula| folded(formula, WIDTH)).collect::<String>();
    lines.push(" ```text".to_owned());
    lines.extend(folded.lines().map(|line| format!(" {line}")));
    lines.push(" ```".to_owned());
}

pub(super) fn integrals(claims: &[&Claim]) -> TokenStream {
    let mut lines =
        vec![" The integrals of motion of the map at `x`; `eps` is ε, half the time step.".to_owned()];
    let statements: Vec<String> = claims.iter().flat_map(|claim| statement_lines(claim)).collect();
    push_block(&mut lines, "In order:", &statements);
    let poles = " Where a divisor is zero, floats are not finite and exact scalars panic.";
    lines.extend([String::new(), poles.to_owned()]);
    emit_lines(&lines)
}

pub(super) fn integral(claim: &Claim) -> TokenStream {
    /// Longer formulas are left out here, because the documentation of `integrals` shows them.
    const MAX_SHOWN_FORMULA: usize = 120;
    let formula =
        statement_lines(claim).into_iter().next().filter(|formula| formula.len() <= MAX_SHOWN_FORMULA);
    let what = formula.unwrap_or_else(|| claim.name.text.clone());
    emit_lines(&[format!(" The integral `{what}`, constant along orbits; `eps` is ε, half the time step.")])
}

/// Writes the documentation of a claim's method, except for integrals without `when`.
pub(super) fn accessor(context: &Context<'_>, claim: &Claim) -> TokenStream {
    let (kind, name) = (claim.kind, &claim.name.text);
    let (introduction, title) = match kind {
        _ if !claim.is_unconditional() => {
            let (kind, conditions) = (kind.keyword(), condition_text(context.system, claim));
            let introduction = format!(
                " The {kind} `{name}` of the map where `{conditions}`, with the values that this gives put in; `eps` is ε, half the time step."
            );
            (introduction, "Namely")
        }
        ClaimKind::Density => (
            " The density ρ of an invariant measure ρ dx: ρ(x̃) det ∂x̃/∂x = ρ(x); `eps` is ε, half the time step."
                .to_owned(),
            "Namely",
        ),
        ClaimKind::Bracket => (
            " An invariant Poisson tensor P: J P(x) Jᵀ = P(x̃) with J = ∂x̃/∂x; `eps` is ε, half the time step."
                .to_owned(),
            "Its entries, those not given being zero:",
        ),
        ClaimKind::Drift | ClaimKind::Integral => (
            format!(
                " `{name}` at `x` and at the next point, the latter by its recurrence; `eps` is ε, half the time step."
            ),
            "Namely, `~` for the next value:",
        ),
    };
    let mut lines = vec![introduction];
    push_block(&mut lines, title, &statement_lines(claim));
    if !claim.is_unconditional() {
        lines.extend([String::new(), " At other parameters it says nothing of the map.".to_owned()]);
    }
    emit_lines(&lines)
}

fn statement_lines(claim: &Claim) -> Vec<String> {
    claim_statement(claim, &Text).into_iter().map(|(name, value)| format!("{name} = {value}")).collect()
}
