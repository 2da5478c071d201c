//! What `kahan discover` found as text and as LaTeX, and what a block of the macro cannot say.

use kahan_algebra::render::{Formulas, Notation, Text, lines as breakable};
use kahan_discover::basis::Basis;
use kahan_discover::report::HamiltonianReport;
use kahan_latex::Latex;
use kahan_latex::breaking::{self, PAGE_WIDTH};
use kahan_study::{ClaimShown, Discovered};

use crate::printing::Refusal;
use crate::printing::layout::{labelled, matrix};
use crate::printing::page::{Page, aligned};

/// What was found, to be written out.
pub(in super::super) struct Discovery(pub(in super::super) Discovered);

impl Discovery {
    /// Summary, sentences, and last the claims, so that they paste as a whole.
    pub(super) fn text(&self) -> String {
        let report = &self.0.report;
        let head = self.head();
        let mut lines: Vec<String> =
            head.iter().flat_map(|row| labelled(&row[0], &row[1], KEY_WIDTH)).collect();
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
        let [states, images] = self.states_and_images(&Text);
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

    /// A point and its image, as vectors.
    pub(in super::super) fn states_and_images(&self, notation: &dyn Notation) -> [String; 2] {
        let states = self.0.report.variables.iter();
        let vector = |entries: Vec<String>| format!("({})", entries.join(", "));
        [
            vector(states.clone().map(|state| notation.name(state)).collect()),
            vector(states.map(|state| notation.image(state)).collect()),
        ]
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
            let [states, images] = self.states_and_images(notation);
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

    /// The numbers, one kind a line.
    pub(in super::super) fn head(&self) -> Vec<[String; 2]> {
        let report = &self.0.report;
        let numbers =
            |values: &[usize]| values.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        let listed = |texts: &[String]| if texts.is_empty() { "none".to_owned() } else { texts.join(", ") };
        let mut fixed: Vec<String> =
            self.0.fixed.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        let mut generic = report.parameters.clone();
        match &self.0.eps {
            Some(eps) => fixed.push(format!("eps = {eps}")),
            None => generic.push("eps".to_owned()),
        }
        let mut rows = vec![
            ["system".to_owned(), self.0.system.clone()],
            ["variables".to_owned(), report.variables.join(", ")],
            ["generic".to_owned(), listed(&generic)],
        ];
        if !fixed.is_empty() {
            rows.push(["fixed".to_owned(), fixed.join(", ")]);
        }
        rows.push(["degrees of iterates".to_owned(), numbers(&report.degrees)]);
        if let Some(hilbert) = &report.hilbert {
            let degrees: Vec<usize> = (1..=hilbert.values.len()).collect();
            rows.push(["monomials of degree".to_owned(), format!("≤ {}", numbers(&degrees))]);
            rows.push(["  on an orbit".to_owned(), numbers(&hilbert.values)]);
            rows.push(["  of all".to_owned(), numbers(&hilbert.full)]);
        }
        let structure = &report.structure;
        // Those of higher degree are not looked for, so that silence says nothing of them.
        let of_flow = [structure.linear_integrals.as_slice(), &structure.quadratic_integrals].concat();
        if !of_flow.is_empty() {
            rows.push(["integrals of the flow".to_owned(), of_flow.join(", ")]);
        }
        rows.push(["seconds".to_owned(), format!("{:.2}", self.0.seconds.unwrap_or_default())]);
        rows
    }
}

/// The width of the words before the numbers.
const KEY_WIDTH: usize = 21;

/// Which coefficients of a basis are integrals, and how they are found from an orbit; formulas
/// stand between marks.
pub(in super::super) fn evaluation(basis: &Basis, notation: &dyn Notation, mark: &str) -> String {
    let quotient = |(above, below): (usize, usize)| {
        let [above, below] = [above, below].map(|number| notation.name(&format!("c{number}")));
        format!("{mark}{above}/{below}{mark}")
    };
    let quotients: Vec<String> = basis.quotients().into_iter().map(quotient).collect();
    let are = match quotients.len() {
        1 => "is an integral",
        _ => "are independent integrals",
    };
    let points = match basis.points() {
        1 => "one point".to_owned(),
        points => format!("{points} consecutive points"),
    };
    format!(
        "{} {are}: along an orbit the coefficients are constant, and the linear equations at {points} of it determine their quotients.",
        quotients.join(", ")
    )
}
