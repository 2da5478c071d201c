//! The formulas of a system on one sheet, as text or as LaTeX.

use kahan_algebra::kahan::TERM_BUDGET;
use kahan_algebra::render::Notation;
use kahan_draw::document::JACOBIAN;
use kahan_latex::Latex;
use kahan_latex::breaking::{self, PAGE_WIDTH};
use kahan_study::{ClaimShown, FormulaSheet};

use crate::printing::page::{Page, aligned, column, matrix, singletons};

pub(super) fn text(sheet: &FormulaSheet) -> String {
    let name = &sheet.system;
    let mut page = Page::default();
    page.line(&sheet.title.map_or_else(|| name.clone(), |title| format!("{name}: {title}")));
    if !sheet.parameters.is_empty() {
        page.line(&format!("parameters: {}", sheet.parameters.join(", ")));
    }
    let equations = |mark: &str, right: &[String]| {
        let states = sheet.variables.iter().zip(right);
        states.map(|(state, value)| format!("{state}{mark} = {value}")).collect::<Vec<_>>()
    };
    let at_zero = match &sheet.field_at_eps {
        Some(at_eps) => {
            page.section("field, with the coefficients of the map at eps", equations("dot", at_eps));
            " at eps = 0"
        }
        None => "",
    };
    page.section(&format!("field{at_zero}"), equations("dot", &sheet.field));
    page.section(&format!("f'(x){at_zero}"), matrix(&sheet.field_jacobian, '[', ']'));
    page.section("A(x,eps) = I - eps f'(x)", matrix(&sheet.matrix, '[', ']'));
    page.section("b(x,eps) = x + eps B x + 2 eps c, and A(x,eps) x~ = b(x,eps)", column(&sheet.rhs));
    page.section(&format!("bilinear form Q(x,x'){at_zero}"), column(&sheet.bilinear));
    match &sheet.determinant {
        Some(determinant) => page.section("D = det A(x,eps)", [determinant]),
        None => page.section(
            &format!("D = det A(x,eps), not expanded: N and D exceed the budget of {TERM_BUDGET} terms"),
            matrix(&sheet.matrix, '|', '|'),
        ),
    }
    match &sheet.map {
        Some(map) => page.section("map, over its common denominator in lowest terms", equations("~", map)),
        None => page.section("map", [MINORS_NOTE]),
    }
    if let Some(factor) = &sheet.removed_factor {
        page.section("divided out of N and D (a removable pole where it vanishes)", [factor]);
    }
    if let Some(jacobian) = &sheet.jacobian {
        page.section("dx~/dx", matrix(jacobian, '[', ']'));
    }
    page.section("Jacobian", ["dx~/dx = A(x,eps)^-1 A(x~,-eps)", "det dx~/dx = det A(x~,-eps)/det A(x,eps)"]);
    if !sheet.claims.is_empty() {
        page.section("claims, proved", sheet.claims.iter().map(claim));
    }
    page.text
}

const MINORS_NOTE: &str = "x~ = x + 2 eps A(x,eps)^-1 f(x), by minors of A or by elimination (--plan tells); det A = 0 counts as a pole";

fn claim(claim: &ClaimShown) -> String {
    let notes = [claim.nonzero.as_str(), claim.source.unwrap_or_default()];
    let notes: Vec<&str> = notes.into_iter().filter(|note| !note.is_empty()).collect();
    let comment = if notes.is_empty() { String::new() } else { format!("    // {}", notes.join("; ")) };
    format!("{}{comment}", claim.statement)
}

pub(super) fn latex(sheet: &FormulaSheet) -> String {
    let equations = |accent: &str, right: &[String]| {
        let states = sheet.variables.iter().map(|state| format!("{accent} {{{}}}", Latex.name(state)));
        let rows = states.zip(right).map(|(left, value)| breaking::equation(&left, value, PAGE_WIDTH));
        aligned(rows.collect())
    };
    let mut page = Page::default();
    page.line(&format!("% {}", sheet.system));
    if let Some(at_eps) = &sheet.field_at_eps {
        page.line("% the field with the coefficients of the map, and f, f' and Q at eps = 0:");
        page.display(&equations("\\dot", at_eps));
    }
    page.display(&equations("\\dot", &sheet.field));
    page.display(&matrix_latex("f'(x)", "pmatrix", &sheet.field_jacobian));
    let matrix = "A(x,\\varepsilon) = I - \\varepsilon f'(x)";
    page.display(&matrix_latex(matrix, "pmatrix", &sheet.matrix));
    page.display(&matrix_latex("b(x,\\varepsilon)", "pmatrix", &singletons(&sheet.rhs)));
    page.display(&matrix_latex("Q(x,x')", "pmatrix", &singletons(&sheet.bilinear)));
    let determinant = "D = \\det A(x,\\varepsilon)";
    page.display(&match &sheet.determinant {
        Some(expanded) => aligned(vec![breaking::equation(determinant, expanded, PAGE_WIDTH)]),
        None => matrix_latex(determinant, "vmatrix", &sheet.matrix),
    });
    match &sheet.map {
        Some(map) => page.display(&equations("\\widetilde", map)),
        None => page.display("\\widetilde x = x + 2\\varepsilon A(x,\\varepsilon)^{-1} f(x)"),
    }
    if let Some(factor) = &sheet.removed_factor {
        page.line("% divided out of the numerators and D:");
        page.display(&breaking::boxed(factor, PAGE_WIDTH));
    }
    page.display(JACOBIAN);
    if let Some(jacobian) = &sheet.jacobian {
        page.display(&matrix_latex("\\frac{\\partial\\widetilde x}{\\partial x}", "pmatrix", jacobian));
    }
    sheet.claims.iter().for_each(|claim| page.claim(claim));
    page.text
}

fn matrix_latex(left: &str, environment: &str, rows: &[Vec<String>]) -> String {
    let room = PAGE_WIDTH.saturating_sub(breaking::width_of(left) + 3);
    format!("{left} = {}", breaking::matrix(environment, rows, room))
}
