//! The systems: field, A(x,ε) and map of each, as the library derives them from the blocks of the
//! catalog, and what it preserves.

use kahan_algebra::lexer::lex;
use kahan_algebra::render::condition_text;
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::{Claim, System};
use maud::{Markup, html};

use super::found::Found;
use super::words::{badge, link};
use kahan_draw::document::{derived, inline, readable, statements};
use kahan_paper::Id;
use kahan_systems::entry::Entry;
use kahan_systems::registry::{FURTHER, SYSTEMS};

/// The system of an entry.
pub(super) fn read(entry: &Entry) -> System {
    kahan_algebra::read(&lex(entry.text()).tokens).system().expect("a system")
}

/// The section.
pub(super) fn section(found: &Found<'_>) -> Markup {
    html! {
        section #systems {
            h2 { "The systems" }
            p {
                "A quadratic field " (inline("\\dot{x} = f(x)")) " has Kahan’s map "
                (inline("\\widetilde{x} = x + 2\\varepsilon A(x,\\varepsilon)^{-1} f(x)")) " with "
                (inline("A(x,\\varepsilon) = I - \\varepsilon f'(x)")) ". The time step is " (inline("2\\varepsilon"))
                ", and the inverse map has " (inline("-\\varepsilon")) " in place of " (inline("\\varepsilon"))
                ". Open a system for its formulas, and for what its map preserves; the maps are in lowest terms."
            }
            @for entry in SYSTEMS { (sheet(entry, found)) }
        }
    }
}

/// The section on the systems that are not in the paper.
pub(super) fn further(found: &Found<'_>) -> Markup {
    html! {
        section #further {
            h2 { "Further systems" }
            p {
                "What is claimed of these fields was found from their equations alone, by " code { "kahan discover" } ", and is "
                "proved with the other claims below. The Lorenz system is a control: nothing was found, so nothing is claimed."
            }
            @for entry in FURTHER { (sheet(entry, found)) }
        }
    }
}

fn sheet(entry: &Entry, found: &Found<'_>) -> Markup {
    let system = read(entry);
    html! {
        details.system id=(format!("system-{}", entry.command)) {
            summary { h3 { (entry.name) } " " span { (readable(entry.title)) } }
            (derived(&system))
            @for (kind, title) in KINDS {
                @let claims: Vec<&Claim> = system.claims.iter().filter(|claim| claim.kind == kind).collect();
                @if !claims.is_empty() {
                    h4 { (title[usize::from(claims.len() > 1)]) }
                    @for claim in claims { (preserved(entry, &system, claim, found)) }
                }
            }
            @if system.claims.is_empty() { p { "Nothing is claimed of this map." } }
        }
    }
}

/// What a map may preserve, with the words for one and for several.
const KINDS: [(ClaimKind, [&str; 2]); 3] = [
    (ClaimKind::Integral, ["Integral", "Integrals"]),
    (ClaimKind::Density, ["Invariant density", "Invariant densities"]),
    (ClaimKind::Bracket, ["Invariant Poisson bracket", "Invariant Poisson brackets"]),
];

/// One claim as formulas, with its condition, its source and its outcome.
fn preserved(entry: &Entry, system: &System, claim: &Claim, found: &Found<'_>) -> Markup {
    let condition = condition_text(system, claim);
    let id = Id::of([entry.command, &claim.name.text]);
    html! {
        div.preserved {
            (statements(claim))
            p.source {
                @if !condition.is_empty() { "when " (readable(&condition)) "; " }
                @if let Some(source) = entry.source(&claim.name.text) { (readable(source)) "; " }
                @match found.claim(&id) {
                    Some(checked) => { (badge(checked.established.outcome)) " (" (link(checked)) ")" },
                    None => { "proved while compiling" },
                }
            }
        }
    }
}
