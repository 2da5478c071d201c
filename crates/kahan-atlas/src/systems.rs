//! The section on systems. Each has its field, A(x,ε) and map from the catalog, and its claims.

use maud::{Markup, html};

use super::found::AtlasContent;
use super::text::{badge, link};
use kahan_draw::document::{claim, formulas, inline, readable};
use kahan_paper::Id;
use kahan_study::{Show, ShowForm, ShownField, Subject, Systems, Unwatched};
use kahan_systems::entry::Entry;
use kahan_systems::registry::{FURTHER, SYSTEMS};

pub(super) fn section(found: &AtlasContent<'_>) -> Markup {
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
            @for entry in SYSTEMS { (system_section(entry, found)) }
        }
    }
}

pub(super) fn further_systems(found: &AtlasContent<'_>) -> Markup {
    html! {
        section #further {
            h2 { "Further systems" }
            p {
                "What is claimed of these fields was found from their equations alone, by " code { "kahan discover" } ", and is "
                "proved with the other claims below. The Lorenz system is a control: nothing was found, so nothing is claimed."
            }
            @for entry in FURTHER { (system_section(entry, found)) }
        }
    }
}

fn system_section(entry: &Entry, found: &AtlasContent<'_>) -> Markup {
    let study = Subject::named(entry.command).study(&Systems).expect("a system of the catalog");
    let asked = Show { form: ShowForm::Latex, jacobian: false };
    let Ok(ShownField::Formulas(sheet)) = asked.ask(&study, &Unwatched) else {
        unreachable!("its claims hold")
    };
    html! {
        details.system id=(format!("system-{}", entry.command)) {
            summary { h3 { (entry.name) } " " span { (readable(entry.title)) } }
            (formulas(&sheet))
            @if sheet.claims.is_empty() { p { "Nothing is claimed of this map." } }
            @else { h4 { "What is claimed" } }
            @for shown in &sheet.claims {
                @let outcome = match found.claim(&Id::of([entry.command, &shown.name])) {
                    Some(checked) => html! { "; " (badge(checked.established.outcome)) " (" (link(checked)) ")" },
                    None => html! { "; proved while compiling" },
                };
                (claim(shown, sheet.variables.len(), &outcome))
            }
        }
    }
}
