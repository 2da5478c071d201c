//! Draws the figures of the paper, and two others, from orbits that the atlas computes.

mod curve;
mod heights;
mod orbit;
mod portrait;
mod summary;

use maud::{Markup, html};

use super::found::AtlasContent;
use super::text::{badge, link};
use kahan_draw::document::readable;

pub(super) struct FigureEntry {
    pub(super) id: &'static str,
    pub(super) title: &'static str,
    pub(super) drawings: Vec<Markup>,
    pub(super) data: Markup,
    pub(super) result: Markup,
    pub(super) claims: &'static [&'static str],
}

fn figure_entries(found: &AtlasContent<'_>) -> Vec<FigureEntry> {
    let orbits = &found.orbits;
    let drawn = [
        heights::overview(orbits),
        heights::lotka_volterra(orbits),
        heights::de3(orbits),
        heights::de4(orbits),
        heights::de7(orbits),
        heights::de9(orbits),
        curve::figure_entry(),
        Some(portrait::figure_entry()),
    ];
    drawn.into_iter().flatten().collect()
}

pub(super) fn titles(found: &AtlasContent<'_>) -> Vec<(&'static str, &'static str)> {
    figure_entries(found).iter().map(|plate| (plate.id, plate.title)).collect()
}

pub(super) fn section(found: &AtlasContent<'_>) -> Markup {
    html! {
        section #figures {
            h2 { "Figures" }
            p {
                "The logarithmic height of a fraction in lowest terms is " i { "h" } "(" i { "p" } "/" i { "q" }
                ") = log max(|" i { "p" } "|, |" i { "q" } "|): about 2.3 times the number of its digits. Where a map "
                "is integrable, heights grow like a power of the number " i { "n" } " of steps at most; where it is not, "
                "they are multiplied by a constant in every step. All logarithms are natural, all steps 2ε long, and all "
                "orbits exact where the caption does not say otherwise."
            }
            @for (index, plate) in figure_entries(found).iter().enumerate() { (figure(found, index + 1, plate)) }
            (summary::table(&found.orbits))
        }
    }
}

fn figure(found: &AtlasContent<'_>, number: usize, plate: &FigureEntry) -> Markup {
    let claims: Vec<_> =
        if plate.claims.is_empty() { Vec::new() } else { found.claims_of(plate.claims).collect() };
    html! {
        figure.single[plate.drawings.len() == 1] id=(plate.id) {
            h3 { "Figure " (number) ". " (plate.title) }
            div.drawings { @for drawing in &plate.drawings { (drawing) } }
            figcaption {
                p.data { (plate.data) }
                p { (plate.result) }
                @if !claims.is_empty() {
                    details {
                        summary { (claims.len()) " claims about this figure" }
                        ul.claims {
                            @for checked in claims {
                                li {
                                    (link(checked)) " " (readable(&checked.claim.source())) " "
                                    (badge(checked.established.outcome))
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}
