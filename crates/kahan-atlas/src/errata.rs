//! The section on errata: misprinted formulas and wrong statements, with their refutations.

use maud::{Markup, html};

use super::found::{AtlasContent, CheckedClaim};
use super::text::{badge, link};
use kahan_draw::decimal;
use kahan_draw::document::readable;
use kahan_draw::document::{COLUMN, displays};
use kahan_paper::figures::{DE1, DE2, DE7, DE7_1_5, DE7_2_9, Figure, slope};
use kahan_paper::formula::latex_of;
use kahan_paper::{Erratum, OPEN, Outcome};

pub(super) fn section(found: &AtlasContent<'_>) -> Markup {
    let is_formula = |checked: &&CheckedClaim<'_>| matches!(checked.claim.erratum, Some(Erratum::A(_)));
    let mut misprints: Vec<&CheckedClaim<'_>> = found.claims.iter().filter(is_formula).collect();
    misprints.sort_by_key(|checked| checked.claim.erratum);
    html! {
        section #errata {
            h2 { "Errata" }
            p {
                "Where a formula of the paper is misprinted, the printed form is refuted at an exact point (or by a measured "
                "value) and the corrected form is established, both while this page was made."
            }
            h3 #errata-formulas { "A. Formulas" }
            @for checked in misprints { (misprint(found, checked)) }
            h3 #errata-statements { "B. Statements" }
            (statements(found))
        }
    }
}

fn misprint(found: &AtlasContent<'_>, checked: &CheckedClaim<'_>) -> Markup {
    let CheckedClaim { claim, established } = checked;
    let lines = latex_of(claim.printed().unwrap_or_default()).unwrap_or_default();
    let lines: Vec<String> =
        lines.iter().map(|item| format!("{} {} {}", item.left, item.sign, item.right)).collect();
    html! {
        article.erratum {
            h4 {
                @if let Some(number) = claim.erratum { span.number { (number) } " " }
                (readable(&claim.place)) " " (badge(established.outcome))
            }
            dl {
                dt { "Printed" } dd.printed { (displays(&lines, COLUMN)) }
                dt { "Correct" } dd { (displays(&found.paper.latex(claim), COLUMN)) }
                dt { "Shown" } dd { (readable(&established.detail)) " (" (link(checked)) ")" }
            }
        }
    }
}

fn measured(
    found: &AtlasContent<'_>,
    figure: &Figure,
    variable: &str,
    from: usize,
    of: fn(f64) -> f64,
) -> String {
    let heights = found.orbits.get(figure.name).and_then(|orbit| orbit.log_heights(variable));
    heights.map_or_else(
        || "(not measured)".to_owned(),
        |heights| decimal(slope(heights.iter().enumerate().skip(from).map(|(n, h)| (of(n as f64), *h))), 2),
    )
}

fn statements(found: &AtlasContent<'_>) -> Markup {
    let linear = |figure: &'static Figure, variable: &str| measured(found, figure, variable, 1, |n| n);
    let logarithmic =
        |figure: &'static Figure, variable: &str| measured(found, figure, variable, 100, libm::log);
    let rows: [(u8, &str, Markup); 12] = [
        (
            1,
            "Section 7, dE7",
            html! {
                "The growth constants are conjectured to be independent of the initial point, with a ratio of e. Measured slopes of h(y"
                sub { "n" } ") and h(z" sub { "n" } "): " (linear(&DE7, "y")) " and " (linear(&DE7, "z")) " from x" sub { "0" } " = 3/7, "
                (linear(&DE7_1_5, "y")) " and " (linear(&DE7_1_5, "z")) " from 1/5, " (linear(&DE7_2_9, "y")) " and "
                (linear(&DE7_2_9, "z")) " from 2/9. Both conjectures are false; the printed 1.64 is a mean over the first iterates."
            },
        ),
        (
            2,
            "Proof of Theorem 4",
            html! {
                "h = log n + O(1) holds for x" sub { "n" } ", not for z" sub { "n" } ": measured slopes of h(z" sub { "n" } ") against "
                "log n are " (logarithmic(&DE1, "z")) " for dE1 and " (logarithmic(&DE2, "z")) " for dE2."
            },
        ),
        (
            3,
            "Proof of Theorem 4",
            html! {
                "The argument bounds the heights of dE7 by 2n log n and n² log n, twice what is printed; growth slower than cubic "
                "follows all the same."
            },
        ),
        (4, "Section 7", html! { "The figure of slope 2 is the one of dE4, not of dE3." }),
        (
            5,
            "Section 7, caption",
            html! {
                "The figure of 400 iterates of dE7 shows log(h/n) of y" sub { "n" } " or z" sub { "n" } "; for x" sub { "n" }
                ", whose h is log n + O(1), it would fall without bound."
            },
        ),
        (
            6,
            "Section 7",
            html! { "τ, not α, stands in the quotient of the recurrence of dE7 and in the solutions of dE1 and dE2." },
        ),
        (
            7,
            "Section 6",
            html! {
                "K₇ and K₈ as printed depend on n. As functions of the point alone they are convergent series: see the claims "
                "section6.e7.K and section6.e8.K."
            },
        ),
        (
            8,
            "Section 1",
            html! {
                "At ε = ±1 a level set of the Lotka–Volterra map’s integral is no quartic of genus zero but a pair of conics that the "
                "map exchanges."
            },
        ),
        (
            9,
            "Section 6.3",
            html! { "The flow E9 has the Painlevé property at ξ = 0 too, not only at ξ = ±1." },
        ),
        (
            10,
            "Section 4",
            html! { "The last factor of the wedge product is the differential of I" sub { "n−2" } ", not the function." },
        ),
        (11, "Section 5", html! { "x, y and z are functions on 2εℤ, as the time step is 2ε." }),
        (
            12,
            "Section 3",
            html! { "Three further examples have one transcendental invariant, not two: E7, E8 and E9." },
        ),
    ];
    html! {
        dl.statements {
            @for (number, place, text) in rows {
                dt { span.number { (Erratum::B(number)) } " " (place) }
                dd {
                    (text)
                    @for checked in claims_about(found, Erratum::B(number)) {
                        @if checked.established.outcome == Outcome::Failed { " " (badge(Outcome::Failed)) }
                        " " (link(checked))
                    }
                }
            }
        }
    }
}

fn claims_about<'f, 'a>(
    found: &'f AtlasContent<'a>,
    erratum: Erratum,
) -> impl Iterator<Item = &'f CheckedClaim<'a>> {
    found.claims.iter().filter(move |checked| checked.claim.erratum == Some(erratum))
}

pub(super) fn open_questions() -> Markup {
    html! {
        section #open {
            h2 { "What is left open" }
            dl { @for open in OPEN { dt { (open.statement) } dd { (readable(open.detail)) "." } } }
        }
    }
}
