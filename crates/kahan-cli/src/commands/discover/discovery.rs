//! What `kahan discover` found, as JSON, as text, as LaTeX, and as a block of the macro.

use kahan_algebra::lexer::lex;
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Formulas, Notation, Text, lines as breakable};
use kahan_algebra::syntax::{ClaimBody, TensorEntry};
use kahan_algebra::system::System;
use kahan_discover::Report;
use kahan_discover::basis::Basis;
use kahan_discover::claims::Formula;
use kahan_discover::report::HamiltonianReport;
use kahan_latex::Latex;
use kahan_latex::breaking::{self, PAGE_WIDTH};
use serde_json::{Map, Value, json};

use crate::printing::Refusal;
use crate::printing::layout::{labelled, matrix};
use crate::printing::page::{Page, aligned};
use crate::reading::Block;

/// What was found, and of what.
pub(in super::super) struct Discovery {
    pub(super) name: String,
    pub(super) system: System,
    pub(super) fixed: Vec<(String, Rational)>,
    pub(super) eps: Option<Rational>,
    pub(in super::super) report: Report,
    pub(super) seconds: f64,
}

impl Discovery {
    pub(super) fn object(&self) -> Result<Value, Refusal> {
        let report = &self.report;
        let fixed = self.fixed.iter().map(|(name, value)| (name.clone(), json!(value.to_string())));
        let generic = report.parameters.iter().map(|name| (name.clone(), Value::Null));
        let hilbert = report.hilbert.as_ref();
        let structure = &report.structure;
        let texts =
            |formulas: &[Formula]| formulas.iter().map(|formula| json!(formula.text)).collect::<Value>();
        Ok(json!({
            "system": self.name,
            "variables": report.variables,
            // null is generic.
            "parameters": fixed.chain(generic).collect::<Map<_, _>>(),
            "eps": self.eps.as_ref().map(ToString::to_string),
            "hilbert": hilbert.map_or_else(Vec::new, |hilbert| hilbert.values.clone()),
            "monomials": hilbert.map_or_else(Vec::new, |hilbert| hilbert.full.clone()),
            "independent_integrals": report.independent_integrals(),
            "most_integrals": report.ceiling.as_ref().map(|ceiling| ceiling.integrals),
            "bounded_by": report.bound.word(),
            "degrees": report.degrees,
            "growth": report.growth.growth.word(),
            "entropy": report.growth.growth.entropy(),
            "linear_integrals": structure.linear_integrals,
            "quadratic_integrals_of_the_flow": structure.quadratic_integrals,
            "integrals": texts(&report.integrals),
            "densities": texts(&report.densities),
            "brackets": report.brackets,
            "found": self.found()?,
            "bases": report.bases.iter().map(|basis| basis_object(basis, &report.variables)).collect::<Value>(),
            "divergence": structure.divergence,
            "is_even": structure.is_even,
            "hamiltonian": structure.hamiltonian.as_ref().map(hamiltonian_object),
            "survivors": self.survivors(),
            "sentences": report.sentences,
            "out_of_time": report.out_of_time,
            "seconds": self.seconds,
        }))
    }

    /// All that is claimed, each claim in its parts: what the block of `--macro` has, and H where
    /// the field is K grad H.
    fn found(&self) -> Result<Vec<Value>, Refusal> {
        let part = |kind: &str, name: &str, expression: &str| json!({ "kind": kind, "name": name, "expression": expression });
        let claims = self.claimed()?.claims;
        let claims = claims.iter().map(|claim| {
            let expression = match &claim.body {
                ClaimBody::Function(value) => Text.expression(value),
                ClaimBody::Tensor(entries) => {
                    let entry = |entry: &TensorEntry| {
                        let (row, column) = (&entry.row.text, &entry.column.text);
                        format!("{{{row}, {column}}} = {};", Text.expression(&entry.value))
                    };
                    entries.iter().map(entry).collect::<Vec<_>>().join(" ")
                }
            };
            part(claim.kind.keyword(), &claim.name.text, &expression)
        });
        let hamiltonian = self.report.structure.hamiltonian.as_ref();
        let hamiltonian = hamiltonian.map(|found| part("hamiltonian", "H", &found.hamiltonian));
        Ok(claims.chain(hamiltonian).collect())
    }

    /// What composition leaves: how many independent integrals, which of the formulas, and which
    /// quotients of two.
    fn survivors(&self) -> Option<Value> {
        let survivors = self.report.survivors.as_ref()?;
        let name = |index: usize| self.report.integrals[index].name().expect("a claim has a name").to_owned();
        let kept = (0..survivors.formulas.len()).filter(|&index| survivors.formulas[index]).map(name);
        let quotients =
            survivors.quotients.iter().map(|&(above, below)| format!("{}/{}", name(above), name(below)));
        Some(json!({
            "independent_integrals": survivors.hilbert.integrals,
            "hilbert": survivors.hilbert.values,
            "formulas": kept.collect::<Vec<_>>(),
            "quotients": quotients.collect::<Vec<_>>(),
        }))
    }

    /// Summary, sentences, and last the claims, so that they paste as a whole.
    pub(super) fn text(&self) -> String {
        let report = &self.report;
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
        let claims = self.claims(self.report.replaced());
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
        let parameters = self.fixed.iter().map(|(name, value)| format!("{name} = {value}"));
        let fixed: Vec<String> =
            parameters.chain(self.eps.as_ref().map(|eps| format!("eps = {eps}"))).collect();
        if fixed.is_empty() { String::new() } else { format!(", when {}", fixed.join(", ")) }
    }

    /// Every basis: its relation, and how it is evaluated.
    fn bases(&self) -> impl Iterator<Item = [String; 2]> {
        let variables = &self.report.variables;
        self.report.bases.iter().enumerate().map(|(number, basis)| {
            let relation = basis.relation(variables, &Text);
            [format!("basis {}{}: {relation}", number + 1, self.condition()), evaluation(basis, &Text, "")]
        })
    }

    /// What a block cannot claim, as comments before it.
    pub(super) fn comments(&self, width: usize) -> String {
        let alone = self.report.compact().filter(|_| self.report.replaced().is_none());
        let modified = alone.map(|hamiltonian| self.modified(hamiltonian));
        let texts = modified.into_iter().chain(self.bases().flatten());
        let comment = |text: String| -> String {
            let rows = breakable(&text, width.saturating_sub(3));
            rows.iter().map(|row| format!("// {row}\n")).collect()
        };
        texts.map(comment).collect()
    }

    /// The claims as text, but for one integral.
    fn claims(&self, but: Option<usize>) -> Vec<&str> {
        let report = &self.report;
        let integrals = (0..report.integrals.len()).filter(|&index| Some(index) != but);
        let integrals = integrals.map(|index| &report.integrals[index]);
        let formulas = integrals.chain(&report.densities).map(|formula| formula.text.as_str());
        formulas.chain(report.brackets.iter().map(String::as_str)).collect()
    }

    /// A point and its image, as vectors.
    pub(in super::super) fn states_and_images(&self, notation: &dyn Notation) -> [String; 2] {
        let states = self.report.variables.iter();
        let vector = |entries: Vec<String>| format!("({})", entries.join(", "));
        [
            vector(states.clone().map(|state| notation.name(state)).collect()),
            vector(states.map(|state| notation.image(state)).collect()),
        ]
    }

    /// The field with what is to be read as its claims: an integral that the compact form of the
    /// modified Hamiltonian replaces is left out.
    pub(in super::super) fn readable(&self) -> Result<System, Refusal> {
        self.with_claims(self.report.replaced())
    }

    /// The field with all that was found as its claims.
    pub(super) fn claimed(&self) -> Result<System, Refusal> {
        self.with_claims(None)
    }

    fn with_claims(&self, but: Option<usize>) -> Result<System, Refusal> {
        let symbols = &self.system.field.symbols;
        let values = Formulas { field: &self.system.field, map: None, notation: &Text }.field();
        let equations =
            symbols.states.iter().zip(values).map(|(state, value)| format!("{state}dot = {value};"));
        let items: Vec<String> = equations.chain(self.claims(but).into_iter().map(str::to_owned)).collect();
        let items = items.join("\n");
        // A header keeps the order of the parameters, and may not name what nothing uses.
        let named = lex(&items).tokens;
        let mut parameters = symbols.parameters.clone();
        parameters.retain(|name| named.iter().any(|token| token.text == *name));
        let text = format!("struct Found {{ {} }}\n{items}", parameters.join(", "));
        let claimed = Block::of_text(text, self.name.clone()).unproved_system()?;
        Ok(System { header: self.system.header.clone(), ..claimed })
    }

    pub(super) fn latex(&self) -> Result<String, Refusal> {
        let system = self.readable()?;
        let notation = &Latex;
        let mut page = Page::default();
        page.line(&format!("% {}", self.name));
        let values = Formulas { field: &system.field, map: None, notation }.field();
        let states =
            system.field.symbols.states.iter().map(|state| format!("\\dot {}", notation.name(state)));
        page.display(&aligned(
            states.zip(&values).map(|(left, right)| breaking::equation(&left, right, PAGE_WIDTH)).collect(),
        ));
        for claim in &system.claims {
            page.claim(&system, claim, None);
        }
        if let Some(hamiltonian) = self.report.compact() {
            page.line(&format!("% modified Hamiltonian{}", self.condition()));
            let equation = breaking::equation("\\widetilde{H}", &hamiltonian.modified(notation), PAGE_WIDTH);
            let [states, images] = self.states_and_images(notation);
            let image = format!("&\\text{{where }} {images} \\text{{ is the image of }} {states}");
            page.display(&aligned(vec![equation, image]));
        }
        for (number, basis) in self.report.bases.iter().enumerate() {
            page.line(&format!("% Hirota-Kimura basis {}{}", number + 1, self.condition()));
            let relation = basis.relation(&self.report.variables, notation);
            let left = relation.strip_suffix(" = 0").unwrap_or(&relation);
            page.display(&aligned(vec![breaking::equation("0", left, PAGE_WIDTH)]));
            page.line(&evaluation(basis, notation, "$"));
        }
        Ok(page.text)
    }

    /// The numbers, one kind a line.
    pub(in super::super) fn head(&self) -> Vec<[String; 2]> {
        let report = &self.report;
        let numbers =
            |values: &[usize]| values.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        let listed = |texts: &[String]| if texts.is_empty() { "none".to_owned() } else { texts.join(", ") };
        let mut fixed: Vec<String> =
            self.fixed.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        let mut generic = report.parameters.clone();
        match &self.eps {
            Some(eps) => fixed.push(format!("eps = {eps}")),
            None => generic.push("eps".to_owned()),
        }
        let mut rows = vec![
            ["system".to_owned(), self.name.clone()],
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
        rows.push(["seconds".to_owned(), format!("{:.2}", self.seconds)]);
        rows
    }
}

/// The width of the words before the numbers.
const KEY_WIDTH: usize = 21;

fn hamiltonian_object(found: &HamiltonianReport) -> Value {
    json!({
        "K": found.tensor,
        "H": found.hamiltonian,
        "modified_is_proved": found.modified_is_proved,
        // At any point x and its image x~.
        "modified": found.modified(&Text),
    })
}

/// Which coefficients of a basis are integrals, and how they are found from an orbit; formulas stand
/// between marks.
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

/// The integrals are quotients of coefficients `c[m]` of the relation Σ `c[m]` m = 0 along an
/// orbit.
fn basis_object(basis: &Basis, variables: &[String]) -> Value {
    let monomials = basis.monomial_texts(variables);
    let unit = &monomials[basis.unit];
    let quotients: Vec<String> =
        basis.integrals.iter().map(|&place| format!("c[{}]/c[{unit}]", monomials[place])).collect();
    json!({
        "monomials": monomials,
        "integrals": quotients,
        // Sums of monomials whose coefficients are equal.
        "terms": basis.term_texts(variables, &Text),
        "points": basis.points(),
        "outcome": if basis.proof.is_some() { "proved-mod-p" } else { "seen" },
    })
}
