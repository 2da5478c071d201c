//! The formulas of a page: what is derived from the field, what is claimed of it, and what
//! `kahan discover` found.

use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Text, macro_block};
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::System;
use kahan_discover::hilbert::default_degree;
use kahan_latex::{Latex, breaking};
use kahan_study::{ClaimShown, Discover, Form, Question, Show, Shown, Systems, Unwatched};
use maud::{Markup, html};

use super::super::discover::{Discovery, discovery, evaluation};
use super::super::line::Line;
use super::figures::{Field, Subject, shown};
use crate::printing::Refusal;
use kahan_draw::document::{LINE, claim, derived, display, readable, rows};

/// The share of the time that the search has.
const SHARE: f64 = 0.35;
/// Larger matrices are no reading.
const MOST_VARIABLES: usize = 8;

/// Field, A, b, map and Jacobian, and the claims that come with the field.
pub(super) fn formulas(subject: &Subject<'_>) -> Markup {
    let asked = Show { form: Form::Latex, jacobian: false };
    let made = asked.ask(&subject.generic.study, &Unwatched).map_err(Refusal::from).map(|answer| {
        let Shown::Formulas(sheet) = answer else { unreachable!("LaTeX is of formulas") };
        html! {
            @if sheet.variables.len() <= MOST_VARIABLES {
                (derived(&sheet))
                h4 { "Jacobian" }
                (display(
                    "\\frac{\\partial\\widetilde x}{\\partial x} = A(x,\\varepsilon)^{-1} A(\\widetilde x,-\\varepsilon), \\qquad \
                     \\det\\frac{\\partial\\widetilde x}{\\partial x} = \
                     \\frac{\\det A(\\widetilde x,-\\varepsilon)}{\\det A(x,\\varepsilon)}",
                    LINE,
                ))
            } @else {
                p { (sheet.variables.len()) " variables have formulas too long for a page; the command below writes them." }
            }
            @if !sheet.claims.is_empty() { h4 { "What is claimed, and proved" } }
            @for shown in &sheet.claims { (claim(shown, &html! {})) }
        }
    });
    shown(made, &Line::asking(&subject.generic.words, &Question::Show(asked)))
}

/// What the search for what the map preserves found, and the call that makes it.
pub(super) struct Search {
    line: Line,
    found: Result<(System, Discovery), Refusal>,
}

impl Search {
    pub(super) fn of(subject: &Subject<'_>, dimension: usize) -> Self {
        // With a degree the search ends where that is looked at, and every page says the same.
        let asked = Discover {
            degree: Some(default_degree(dimension)),
            seconds: subject.share(SHARE),
            ..Discover::default()
        };
        let line = Line::asking(&subject.generic.words, &Question::Discover(asked.clone()));
        let found = discovery(&subject.generic.study, &asked);
        let found = found.and_then(|discovery| Ok((discovery.0.readable()?, discovery)));
        Search { line, found }
    }

    /// What the map preserves, found from the equations alone.
    pub(super) fn chapter(&self) -> Markup {
        let found = self.found.as_ref().map(|(claimed, discovery)| findings(claimed, discovery));
        shown(found, &self.line)
    }

    /// The field with the integrals that were found, at these values of its parameters; `None` where there are none, or too long ones for a line that one reads.
    pub(super) fn with_integrals(&self, values: &[(String, Rational)]) -> Option<Field> {
        /// Longer lines are no reading.
        const LONGEST: usize = 800;

        let (claimed, _) = self.found.as_ref().ok()?;
        let claims = claimed.claims.iter().filter(|claim| claim.kind == ClaimKind::Integral);
        let claimed = System { claims: claims.cloned().collect(), ..claimed.clone() };
        let names = claimed.field.symbols.parameters.iter().enumerate();
        let values = names.filter_map(|(k, name)| {
            let (_, value) = values.iter().find(|(known, _)| known == name)?;
            Some((k, value.clone()))
        });
        let at_values = claimed.specialise(&values.collect::<Vec<_>>())?;
        let block = macro_block(&at_values);
        let body = block.strip_prefix("kahan! {").and_then(|block| block.strip_suffix('}'))?;
        let words: Vec<&str> = body.split_whitespace().collect();
        let text = words.join(" ");
        let has_integrals = at_values.accessors(ClaimKind::Integral).next().is_some();
        if !has_integrals || text.len() > LONGEST {
            return None;
        }
        let study = kahan_study::Subject::text(&text).study(&Systems).ok()?;
        Some(Field { words: vec!["--field".to_owned(), text], study })
    }
}

fn findings(claimed: &System, discovery: &Discovery) -> Markup {
    let report = &discovery.0.report;
    let numbers = discovery.head().into_iter().map(|row| row.to_vec());
    let numbers: Vec<Vec<String>> =
        [["what", "found"].map(str::to_owned).to_vec()].into_iter().chain(numbers).collect();
    html! {
        @if claimed.claims.is_empty() && report.bases.is_empty() && report.compact().is_none() {
            p { "No integral, density or bracket was found." }
        } @else if !claimed.claims.is_empty() {
            p { "Each formula was proved when this page was written." }
            @for found in &claimed.claims { (claim(&ClaimShown::of(claimed, found, Some(&Latex)), &html! {})) }
        }
        @if let Some(hamiltonian) = &report.structure.hamiltonian {
            p { "The flow is Hamiltonian: f = K ∇H with a constant antisymmetric K." }
            (display(&format!("K = {}", breaking::matrix("pmatrix", &hamiltonian.tensor, LINE)), LINE))
        }
        @if let Some(hamiltonian) = report.compact() {
            @let [states, images] = discovery.states_and_images(&Text);
            p { "The modified Hamiltonian, where " (readable(&images)) " is the image of " (readable(&states)) ":" }
            (display(&format!("\\widetilde{{H}} = {}", hamiltonian.modified(&Latex)), LINE))
        }
        @for basis in &report.bases {
            p { "A Hirota–Kimura basis, " @if basis.proof.is_none() { "as seen modulo primes" } @else { "proved" } ":" }
            (display(&basis.relation(&report.variables, &Latex), LINE))
            p { (readable(&evaluation(basis, &Text, ""))) }
        }
        ul { @for sentence in &report.sentences { li { (readable(sentence)) } } }
        (rows("Numbers of the search", &numbers))
    }
}
