//! The section on verification: every claim with its place in the paper and its outcome.

use maud::{Markup, html};

use super::found::{AtlasContent, CheckedClaim};
use super::text::{anchor, badge};
use kahan_draw::document::readable;
use kahan_draw::document::{COLUMN, displays};
use kahan_paper::{Outcome, Section};

pub(super) fn section(found: &AtlasContent<'_>) -> Markup {
    html! {
        section #verification {
            h2 { "Verification" }
            (counts(found))
            p {
                "Definitions come before the relations that use them; names that are not defined stand for variables or "
                "for what an earlier claim defines. “Proved” means that both sides agree when they are expanded over ℚ, and "
                "modulo primes too; “mod p” that they agree at random points modulo primes, with an error probability below "
                "2" sup { "−100" } "; “exact at points” that they agree exactly there; “numerical” that they agree in 256-bit "
                "arithmetic, or that measured values agree, to the power of ten that is given."
            }
            @for part in Section::ALL { (group(part, found)) }
        }
    }
}

pub(super) fn counts(found: &AtlasContent<'_>) -> Markup {
    let kinds = [
        ("proved", "proved over ℚ"),
        ("proved", "proved mod p"),
        ("exact", "exact at points"),
        ("numerical", "numerical"),
        ("misprint", "misprints corrected"),
        ("failed", "failed"),
    ];
    let rows = kinds.into_iter().zip(found.counts());
    html! {
        ul.counts aria-label="Claims by outcome" {
            li { b { (found.claims.len()) } " claims" }
            @for ((class, words), number) in rows { li.(class) { b { (number) } " " (words) } }
        }
    }
}

fn group(part: Section, found: &AtlasContent<'_>) -> Markup {
    let claims: Vec<&CheckedClaim<'_>> =
        found.claims.iter().filter(|checked| checked.claim.section == part).collect();
    let failed = claims.iter().any(|checked| checked.established.outcome == Outcome::Failed);
    html! {
        details.group open[failed] {
            summary { h3 { (part.place()) ": " (part.subject()) } " " span { (claims.len()) @if claims.len() == 1 { " claim" } @else { " claims" } } }
            table.claims {
                thead { tr { th scope="col" { "Claim" } th scope="col" { "Statement" } th scope="col" { "Outcome" } } }
                tbody { @for checked in &claims { (row(checked, found)) } }
            }
        }
    }
}

fn row(checked: &CheckedClaim<'_>, found: &AtlasContent<'_>) -> Markup {
    let CheckedClaim { claim, established } = checked;
    html! {
        tr id=(anchor(&claim.id)) {
            th scope="row" { code { (claim.id) } div.source { (readable(&claim.source())) } }
            td { (displays(&found.paper.latex(claim), COLUMN)) }
            td {
                (badge(established.outcome))
                @if matches!(established.outcome, Outcome::Exact(_) | Outcome::Failed) {
                    div.source { (readable(&established.detail)) }
                }
            }
        }
    }
}
