//! What `kahan discover` found as text and as LaTeX, and what a block of the macro cannot say.

use kahan_algebra::render::{Formulas, Notation, Text, lines as breakable};
use kahan_discover::report::HamiltonianReport;
use kahan_draw::answer::{evaluation, numbers, states_and_images};
use kahan_latex::Latex;
use kahan_latex::breaking::{self, PAGE_WIDTH};
use kahan_study::{ClaimShown, Discovered};

use crate::printing::Refusal;
use crate::printing::layout::{labelled, matrix};
use crate::printing::page::{Page, aligned};

/// Summary, sentences, and last the claims, so that they paste as a whole.
pub(super) fn text(found: &Discovered) -> String {
    let report = &found.report;
    let numbers = numbers(found).rows.into_iter().skip(1);
    let mut lines: Vec<String> = numbers.flat_map(|row| labelled(&row[0], &row[1], KEY_WIDTH)).collect();
    lines.push(String::new());
    lines.extend(report.sentences.iter().cloned());
    if let Some(hamiltonian) = &report.structure.hamiltonian {
        lines.push(String::new());
        lines.push("K =".to_owned());
        lines.extend(matrix(&hamiltonian.tensor, '[', ']').iter().map(|row| format!("  {row}")));
    }
    if let Some(hamiltonian) = report.compact() {
        lines.push(String::new());
        lines.push(modified(found, hamiltonian));
    }
    for basis in bases(found) {
        lines.push(String::new());
        lines.extend(basis);
    }
    let claims = found.claims(found.report.replaced());
    if !claims.is_empty() {
        lines.push(String::new());
        lines.extend(claims.iter().map(|claim| (*claim).to_owned()));
    }
    lines.join("\n") + "\n"
}

/// The modified Hamiltonian in its compact form.
fn modified(found: &Discovered, hamiltonian: &HamiltonianReport) -> String {
    let [states, images] = states_and_images(&found.report, &Text);
    format!(
        "H~ = {}, where {images} is the image of {states}{}",
        hamiltonian.modified(&Text),
        condition(found)
    )
}

/// `, when a = 1, eps = 1/2`, or empty.
fn condition(found: &Discovered) -> String {
    let parameters = found.fixed.iter().map(|(name, value)| format!("{name} = {value}"));
    let fixed: Vec<String> = parameters.chain(found.eps.as_ref().map(|eps| format!("eps = {eps}"))).collect();
    if fixed.is_empty() { String::new() } else { format!(", when {}", fixed.join(", ")) }
}

/// Every basis: its relation, and how it is evaluated.
fn bases(found: &Discovered) -> impl Iterator<Item = [String; 2]> {
    let variables = &found.report.variables;
    found.report.bases.iter().enumerate().map(|(number, basis)| {
        let relation = basis.relation(variables, &Text);
        [format!("basis {}{}: {relation}", number + 1, condition(found)), evaluation(basis, &Text, "")]
    })
}

/// What a block cannot claim, as comments before it.
pub(super) fn comments(found: &Discovered, width: usize) -> String {
    let alone = found.report.compact().filter(|_| found.report.replaced().is_none());
    let modified = alone.map(|hamiltonian| modified(found, hamiltonian));
    let texts = modified.into_iter().chain(bases(found).flatten());
    let comment = |text: String| -> String {
        let rows = breakable(&text, width.saturating_sub(3));
        rows.iter().map(|row| format!("// {row}\n")).collect()
    };
    texts.map(comment).collect()
}

pub(super) fn latex(found: &Discovered) -> Result<String, Refusal> {
    let system = found.readable()?;
    let notation = &Latex;
    let mut page = Page::default();
    page.line(&format!("% {}", found.system));
    let values = Formulas { field: &system.field, map: None, notation }.field();
    let states = system.field.symbols.states.iter().map(|state| format!("\\dot {}", notation.name(state)));
    page.display(&aligned(
        states.zip(&values).map(|(left, right)| breaking::equation(&left, right, PAGE_WIDTH)).collect(),
    ));
    for claim in &system.claims {
        page.claim(&ClaimShown::of(&system, claim, Some(notation)));
    }
    if let Some(hamiltonian) = found.report.compact() {
        page.line(&format!("% modified Hamiltonian{}", condition(found)));
        let equation = breaking::equation("\\widetilde{H}", &hamiltonian.modified(notation), PAGE_WIDTH);
        let [states, images] = states_and_images(&found.report, notation);
        let image = format!("&\\text{{where }} {images} \\text{{ is the image of }} {states}");
        page.display(&aligned(vec![equation, image]));
    }
    for (number, basis) in found.report.bases.iter().enumerate() {
        page.line(&format!("% Hirota-Kimura basis {}{}", number + 1, condition(found)));
        let relation = basis.relation(&found.report.variables, notation);
        let left = relation.strip_suffix(" = 0").unwrap_or(&relation);
        page.display(&aligned(vec![breaking::equation("0", left, PAGE_WIDTH)]));
        page.line(&evaluation(basis, notation, "$"));
    }
    Ok(page.text)
}

/// The width of the words before the numbers.
const KEY_WIDTH: usize = 21;
