//! The formulas of a system on one sheet: as text, as LaTeX, or as JSON.

use kahan_algebra::kahan::{RationalMap, TERM_BUDGET};
use kahan_algebra::render::{
    Formulas, MatrixText, Notation, claim_text, condition_note, condition_text, macro_block,
};
use kahan_algebra::system::{Claim, System};
use kahan_latex::breaking::{self, PAGE_WIDTH};
use serde_json::{Value, json};

use crate::printing::page::{Page, aligned, column, matrix, singletons};
use crate::reading::Block;

/// Everything that is shown, in one notation.
pub(super) struct Sheet<'a> {
    block: &'a Block,
    system: &'a System,
    notation: &'a dyn Notation,
    field: Vec<String>,
    field_jacobian: MatrixText,
    matrix: MatrixText,
    rhs: Vec<String>,
    bilinear: Vec<String>,
    /// `None` beyond the budget, like the map.
    determinant: Option<String>,
    map: Option<Vec<String>>,
    removed_factor: Option<String>,
}

impl<'a> Sheet<'a> {
    /// Derives the formulas of a system.
    pub(super) fn of(block: &'a Block, system: &'a System, notation: &'a dyn Notation) -> Self {
        let map = RationalMap::of(&system.field);
        let formulas = Formulas { field: &system.field, map: map.as_ref(), notation };
        Sheet {
            block,
            system,
            notation,
            field: formulas.field(),
            field_jacobian: formulas.field_jacobian(),
            matrix: formulas.matrix(),
            rhs: formulas.rhs(),
            bilinear: formulas.bilinear(),
            determinant: formulas.determinant(),
            map: formulas.map(),
            removed_factor: formulas.removed_factor(),
        }
    }

    fn states(&self) -> &[String] {
        &self.system.field.symbols.states
    }

    fn source(&self, claim: &Claim) -> Option<&'static str> {
        self.block.entry.and_then(|entry| entry.source(&claim.name.text))
    }

    pub(super) fn json(&self) -> Value {
        let claims = self.system.claims.iter().map(|claim| {
            json!({
                "name": claim.name.text,
                "kind": claim.kind.keyword(),
                "statement": claim_text(self.system, claim),
                "when": condition_text(self.system, claim),
                "nonzero": condition_note(self.system, claim),
                "source": self.source(claim),
            })
        });
        json!({
            "system": self.block.name(self.system),
            "title": self.block.entry.map(|entry| entry.title),
            "variables": self.states(),
            "parameters": self.system.field.symbols.parameters,
            "field": self.field,
            "field_jacobian": self.field_jacobian,
            "A": self.matrix,
            "b": self.rhs,
            "bilinear": self.bilinear,
            "det_A": self.determinant,
            "map": self.map,
            "removed_factor": self.removed_factor,
            "claims": claims.collect::<Vec<_>>(),
            "macro": macro_block(self.system),
        })
    }

    pub(super) fn text(&self) -> String {
        let name = self.block.name(self.system);
        let mut page = Page::default();
        page.line(&self.block.entry.map_or_else(|| name.clone(), |entry| format!("{name}: {}", entry.title)));
        let parameters = &self.system.field.symbols.parameters;
        if !parameters.is_empty() {
            page.line(&format!("parameters: {}", parameters.join(", ")));
        }
        page.section("field", self.equations(|state| format!("{state}dot"), &self.field));
        page.section("f'(x)", matrix(&self.field_jacobian, '[', ']'));
        page.section("A(x,eps) = I - eps f'(x)", matrix(&self.matrix, '[', ']'));
        page.section("b(x,eps) = x + eps B x + 2 eps c, and A(x,eps) x~ = b(x,eps)", column(&self.rhs));
        page.section("bilinear form Q(x,x')", column(&self.bilinear));
        match &self.determinant {
            Some(determinant) => page.section("D = det A(x,eps)", vec![determinant.clone()]),
            None => page.section(
                &format!("D = det A(x,eps), not expanded: N and D exceed the budget of {TERM_BUDGET} terms"),
                matrix(&self.matrix, '|', '|'),
            ),
        }
        match &self.map {
            Some(map) => {
                page.section(
                    "map, over its common denominator in lowest terms",
                    self.equations(|state| format!("{state}~"), map),
                );
            }
            None => page.section(
                "map",
                vec![
                    "x~ = x + 2 eps A(x,eps)^-1 f(x), by minors of A or by elimination (--plan tells); det A = 0 counts as a pole"
                        .to_owned(),
                ],
            ),
        }
        if let Some(factor) = &self.removed_factor {
            page.section("divided out of N and D (a removable pole where it vanishes)", vec![factor.clone()]);
        }
        page.section(
            "Jacobian",
            vec![
                "dx~/dx = A(x,eps)^-1 A(x~,-eps)".to_owned(),
                "det dx~/dx = det A(x~,-eps)/det A(x,eps)".to_owned(),
            ],
        );
        if !self.system.claims.is_empty() {
            let claims = self.system.claims.iter().map(|claim| {
                let notes = [condition_note(self.system, claim), self.source(claim).unwrap_or("").to_owned()];
                let notes = notes.into_iter().filter(|note| !note.is_empty()).collect::<Vec<_>>().join("; ");
                let comment = if notes.is_empty() { notes } else { format!("    // {notes}") };
                claim_text(self.system, claim) + &comment
            });
            page.section("claims, proved", claims.collect());
        }
        page.text
    }

    fn equations(&self, left: impl Fn(&str) -> String, right: &[String]) -> Vec<String> {
        self.states().iter().zip(right).map(|(state, value)| format!("{} = {value}", left(state))).collect()
    }

    pub(super) fn latex(&self) -> String {
        let mut page = Page::default();
        page.line(&format!("% {}", self.block.name(self.system)));
        page.display(&aligned(self.equations_latex(|state| format!("\\dot {{{state}}}"), &self.field)));
        page.display(&matrix_latex("f'(x)", "pmatrix", &self.field_jacobian));
        let matrix = "A(x,\\varepsilon) = I - \\varepsilon f'(x)";
        page.display(&matrix_latex(matrix, "pmatrix", &self.matrix));
        page.display(&matrix_latex("b(x,\\varepsilon)", "pmatrix", &singletons(&self.rhs)));
        page.display(&matrix_latex("Q(x,x')", "pmatrix", &singletons(&self.bilinear)));
        let determinant = "D = \\det A(x,\\varepsilon)";
        page.display(&match &self.determinant {
            Some(expanded) => aligned(vec![breaking::equation(determinant, expanded, PAGE_WIDTH)]),
            None => matrix_latex(determinant, "vmatrix", &self.matrix),
        });
        match &self.map {
            Some(map) => {
                page.display(&aligned(self.equations_latex(|state| format!("\\widetilde {{{state}}}"), map)));
            }
            None => page.display("\\widetilde x = x + 2\\varepsilon A(x,\\varepsilon)^{-1} f(x)"),
        }
        if let Some(factor) = &self.removed_factor {
            page.line("% divided out of the numerators and D:");
            page.display(&breaking::boxed(factor, PAGE_WIDTH));
        }
        page.display(
            "\\frac{\\partial\\widetilde x}{\\partial x} = A(x,\\varepsilon)^{-1} A(\\widetilde x,-\\varepsilon), \\qquad \
             \\det\\frac{\\partial\\widetilde x}{\\partial x} = \
             \\frac{\\det A(\\widetilde x,-\\varepsilon)}{\\det A(x,\\varepsilon)}",
        );
        for claim in &self.system.claims {
            page.claim(self.system, claim, self.source(claim));
        }
        page.text
    }

    fn equations_latex(&self, left: impl Fn(&str) -> String, right: &[String]) -> Vec<String> {
        let states = self.states().iter().map(|state| self.notation.name(state));
        states.zip(right).map(|(state, value)| breaking::equation(&left(&state), value, PAGE_WIDTH)).collect()
    }
}

/// `left = matrix` in LaTeX.
fn matrix_latex(left: &str, environment: &str, rows: &[Vec<String>]) -> String {
    let room = PAGE_WIDTH.saturating_sub(breaking::width_of(left) + 3);
    format!("{left} = {}", breaking::matrix(environment, rows, room))
}
