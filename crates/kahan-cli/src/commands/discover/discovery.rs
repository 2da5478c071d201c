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

/// What was found, to be written out.
pub(super) struct Discovery(pub(super) Discovered);

impl Discovery {
    /// Summary, sentences, and last the claims, so that they paste as a whole.
    pub(super) fn text(&self) -> String {
        let report = &self.0.report;
        let numbers = numbers(&self.0).rows.into_iter().skip(1);
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
            lines.push(self.modified(hamiltonian));
        }
        for basis in self.bases() {
            lines.push(String::new());
            lines.extend(basis);
        }
        let claims = self.0.claims(self.0.report.replaced());
        if !claims.is_empty() {
            lines.push(String::new());
            lines.extend(claims.iter().map(|claim| (*claim).to_owned()));
        }
        lines.join("\n") + "\n"
    }

    /// The modified Hamiltonian in its compact form.
    fn modified(&self, hamiltonian: &HamiltonianReport) -> String {
        let [states, images] = states_and_images(&self.0.report, &Text);
        format!(
            "H~ = {}, where {images} is the image of {states}{}",
            hamiltonian.modified(&Text),
            self.condition()
        )
    }

    /// `, when a = 1, eps = 1/2`, or empty.
    fn condition(&self) -> String {
        let parameters = self.0.fixed.iter().map(|(name, value)| format!("{name} = {value}"));
        let fixed: Vec<String> =
            parameters.chain(self.0.eps.as_ref().map(|eps| format!("eps = {eps}"))).collect();
        if fixed.is_empty() { String::new() } else { format!(", when {}", fixed.join(", ")) }
    }

    /// Every basis: its relation, and how it is evaluated.
    fn bases(&self) -> impl Iterator<Item = [String; 2]> {
        let variables = &self.0.report.variables;
        self.0.report.bases.iter().enumerate().map(|(number, basis)| {
            let relation = basis.relation(variables, &Text);
            [format!("basis {}{}: {relation}", number + 1, self.condition()), evaluation(basis, &Text, "")]
        })
    }

    /// What a block cannot claim, as comments before it.
    pub(super) fn comments(&self, width: usize) -> String {
        let alone = self.0.report.compact().filter(|_| self.0.report.replaced().is_none());
        let modified = alone.map(|hamiltonian| self.modified(hamiltonian));
        let texts = modified.into_iter().chain(self.bases().flatten());
        let comment = |text: String| -> String {
            let rows = breakable(&text, width.saturating_sub(3));
            rows.iter().map(|row| format!("// {row}\n")).collect()
        };
        texts.map(comment).collect()
    }

    pub(super) fn latex(&self) -> Result<String, Refusal> {
        let system = self.0.readable()?;
        let notation = &Latex;
        let mut page = Page::default();
        page.line(&format!("% {}", self.0.system));
        let values = Formulas { field: &system.field, map: None, notation }.field();
        let states =
            system.field.symbols.states.iter().map(|state| format!("\\dot {}", notation.name(state)));
        page.display(&aligned(
            states.zip(&values).map(|(left, right)| breaking::equation(&left, right, PAGE_WIDTH)).collect(),
        ));
        for claim in &system.claims {
            page.claim(&ClaimShown::of(&system, claim, Some(notation)));
        }
        if let Some(hamiltonian) = self.0.report.compact() {
            page.line(&format!("% modified Hamiltonian{}", self.condition()));
            let equation = breaking::equation("\\widetilde{H}", &hamiltonian.modified(notation), PAGE_WIDTH);
            let [states, images] = states_and_images(&self.0.report, notation);
            let image = format!("&\\text{{where }} {images} \\text{{ is the image of }} {states}");
            page.display(&aligned(vec![equation, image]));
        }
        for (number, basis) in self.0.report.bases.iter().enumerate() {
            page.line(&format!("% Hirota-Kimura basis {}{}", number + 1, self.condition()));
            let relation = basis.relation(&self.0.report.variables, notation);
            let left = relation.strip_suffix(" = 0").unwrap_or(&relation);
            page.display(&aligned(vec![breaking::equation("0", left, PAGE_WIDTH)]));
            page.line(&evaluation(basis, notation, "$"));
        }
        Ok(page.text)
    }
}

/// The width of the words before the numbers.
const KEY_WIDTH: usize = 21;
