//! The verification: every claim, where it stands, what it says, and how it was established.

use maud::{Markup, html};

use super::found::{Checked, Found};
use super::math::{COLUMN, displays};
use super::readable::readable;
use super::words::{anchor, badge};
use kahan_paper::Outcome;

/// A group of claims: its title, and what the sources of its claims begin with.
const GROUPS: [(&str, &[&str]); 12] = [
    ("Section 1: Kahan’s method and the Lotka–Volterra map", &["Section 1"]),
    ("Section 2: Poisson structures and the Euler top", &["Section 2"]),
    ("Section 3 and Table 1: Lie–Poisson pairs", &["Section 3", "Table 1"]),
    ("Section 4: invariant brackets from integrals", &["Section 4"]),
    ("Section 5: the maps, Table 2 and Theorem 1", &["Section 5", "Table 2", "Theorem 1"]),
    ("Tables 3 and 4, Theorem 2: Poisson pairs of the maps", &["Table 3", "Table 4", "Theorem 2"]),
    ("Table 5: solutions of the flows", &["Table 5"]),
    ("Theorem 3: solutions of the maps", &["Theorem 3"]),
    ("Section 6: dE7, dE8 and dE9", &["Section 6"]),
    ("Section 7 and Theorem 4: the Diophantine test", &["Section 7", "Theorem 4"]),
    ("Appendix: elliptic curves and theta functions", &["Appendix"]),
    ("Beyond the paper: further systems", &["found by kahan discover", "from kahan discover"]),
];

/// The section.
pub(super) fn section(found: &Found<'_>) -> Markup {
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
            @for (title, claims) in groups(found) { @if !claims.is_empty() { (group(&title, &claims, found)) } }
        }
    }
}

/// The claims by section; what belongs to none comes last.
fn groups<'f, 'a>(found: &'f Found<'a>) -> Vec<(String, Vec<&'f Checked<'a>>)> {
    let mut groups: Vec<(String, Vec<&Checked<'_>>)> =
        GROUPS.iter().map(|(title, _)| ((*title).to_owned(), Vec::new())).collect();
    groups.push(("Others".to_owned(), Vec::new()));
    for checked in &found.claims {
        let belongs =
            |prefixes: &[&str]| prefixes.iter().any(|prefix| checked.claim.source.starts_with(prefix));
        let index = GROUPS.iter().position(|(_, prefixes)| belongs(prefixes)).unwrap_or(GROUPS.len());
        groups[index].1.push(checked);
    }
    groups
}

/// How many claims came out how.
pub(super) fn counts(found: &Found<'_>) -> Markup {
    let count = |which: fn(Outcome) -> bool| found.count(which);
    let rows = [
        ("proved", "proved over ℚ", count(|outcome| outcome == Outcome::Proved)),
        ("proved", "proved mod p", count(|outcome| outcome == Outcome::ProvedModP)),
        ("exact", "exact at points", count(|outcome| matches!(outcome, Outcome::Exact(_)))),
        ("numerical", "numerical", count(|outcome| matches!(outcome, Outcome::Numerical(_)))),
        ("misprint", "misprints corrected", count(|outcome| outcome == Outcome::Misprint)),
        ("failed", "failed", found.failed()),
    ];
    html! {
        ul.counts aria-label="Claims by outcome" {
            li { b { (found.claims.len()) } " claims" }
            @for (class, words, number) in rows { li.(class) { b { (number) } " " (words) } }
        }
    }
}

fn group(title: &str, claims: &[&Checked<'_>], found: &Found<'_>) -> Markup {
    let failed = claims.iter().any(|checked| checked.established.outcome == Outcome::Failed);
    html! {
        details.group open[failed] {
            summary { h3 { (title) } " " span { (claims.len()) @if claims.len() == 1 { " claim" } @else { " claims" } } }
            table.claims {
                thead { tr { th scope="col" { "Claim" } th scope="col" { "Statement" } th scope="col" { "Outcome" } } }
                tbody { @for checked in claims { (row(checked, found)) } }
            }
        }
    }
}

fn row(checked: &Checked<'_>, found: &Found<'_>) -> Markup {
    let Checked { claim, established } = checked;
    html! {
        tr id=(anchor(&claim.id)) {
            th scope="row" { code { (claim.id) } div.source { (readable(&claim.source)) } }
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
