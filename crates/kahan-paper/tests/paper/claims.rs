//! Tests that the registry lists all claims, that claims are established, and that none is vacuous.

use std::collections::BTreeSet;

use kahan_paper::formula::mutations;
use kahan_paper::{Claim, Erratum, OPEN, Outcome, Paper, Section};

use crate::paper;

fn ids(paper: &Paper) -> BTreeSet<String> {
    paper.claims().iter().map(|claim| claim.id.to_string()).collect()
}

#[test]
fn every_claim_is_established_and_fails_under_a_mutation() {
    let paper = paper();
    let claims: Vec<&Claim> = paper.claims().iter().collect();
    let failed: Vec<String> = claims
        .iter()
        .zip(paper.for_all(&claims, None, |claim| paper.establish(claim)))
        .filter(|(_, established)| established.outcome == Outcome::Failed)
        .map(|(claim, established)| format!("{}: {}", claim.id, established.detail))
        .collect();
    assert!(failed.is_empty(), "{}", failed.join("\n"));
    let is_vacuous = |claim: &Claim| {
        !mutations(&claim.statement)
            .iter()
            .any(|mutation| paper.establish_as(claim, mutation).outcome == Outcome::Failed)
    };
    let vacuous: Vec<String> = claims
        .iter()
        .zip(paper.for_all(&claims, None, is_vacuous))
        .filter(|(_, vacuous)| *vacuous)
        .map(|(claim, _)| claim.id.to_string())
        .collect();
    assert!(vacuous.is_empty(), "these survive every mutation: {vacuous:?}");
}

#[test]
fn every_claim_has_a_name_of_its_own_a_place_and_a_statement() {
    let paper = paper();
    assert!(paper.claims().len() >= 200);
    assert_eq!(ids(paper).len(), paper.claims().len());
    for claim in paper.claims() {
        assert!(!claim.source().is_empty() && !claim.statement.is_empty(), "{}", claim.id);
        assert!(!paper.latex(claim).is_empty(), "{} has no formula to show", claim.id);
    }
    assert!(!OPEN.is_empty());
}

#[test]
fn no_cell_of_a_table_is_missing() {
    let paper = paper();
    let ids = ids(paper);
    let has = |id: String| assert!(ids.contains(&id), "{id} is missing");
    for i in 1..=9 {
        for cell in ["P", "Q", "H", "K", "c"] {
            has(format!("table1.e{i}.{cell}"));
        }
        for system in ["field", "matrix", "determinant"] {
            has(format!("{system}.e{i}"));
        }
    }
    for i in 1..=6 {
        for id in ["H", "K", "rho", "P", "Q"] {
            has(format!("e{i}.{id}"));
        }
        for entry in ["12", "23", "31"] {
            has(format!("table3.e{i}.P{entry}"));
            has(format!("table4.e{i}.Q{entry}"));
        }
    }
    for i in [1, 2, 3, 4, 5, 7, 8] {
        for cell in ["x", "y", "z"] {
            has(format!("table5.e{i}.{cell}"));
        }
    }
    for i in 1..=5 {
        for cell in ["x", "y", "z", "H", "K"] {
            has(format!("theorem3.e{i}.{cell}"));
        }
    }
}

#[test]
fn every_erratum_of_a_formula_is_refuted_as_printed() {
    let paper = paper();
    for number in (1..=10).map(Erratum::A).chain([Erratum::B(1), Erratum::B(2)]) {
        let about = paper.claims().iter().filter(|claim| claim.erratum == Some(number));
        let corrected: Vec<&Claim> = about.filter(|claim| claim.printed().is_some()).collect();
        assert!(!corrected.is_empty(), "no claim corrects {number}");
        for claim in corrected {
            assert_eq!(paper.establish(claim).outcome, Outcome::Misprint, "{}", claim.id);
        }
    }
}

#[test]
fn a_correction_sets_what_is_printed_beside_what_is_right() {
    let paper = paper();
    let correction = |number| {
        let corrects = |claim: &&Claim| claim.erratum == Some(number) && claim.printed().is_some();
        paper.claims().iter().find(corrects).and_then(Claim::correction).expect("a correction")
    };
    let pair = |printed: &str, right: &str| (printed.to_owned(), right.to_owned());
    assert_eq!(correction(Erratum::A(3)), pair("Z(n) := solution(n, 2)", "Z(n) := solution(n, 4)"));
    assert_eq!(
        correction(Erratum::A(6)),
        pair("(1 - 2*K*eps^2)*(s^2 + d^2) + 4*z^2 = 4*K", "(1 - 2*K*eps^2)*(s^2 + d^2) + 2*z^2 = 4*K")
    );
    assert_eq!(correction(Erratum::A(10)), pair("log(h(x, 17))/log(10) ~ 325009", "digits(x, 17) = 325009"));
}

#[test]
fn no_section_is_without_claims() {
    let paper = paper();
    for section in Section::ALL {
        assert!(paper.claims().iter().any(|claim| claim.section == section), "{section:?}");
    }
}

#[test]
fn what_is_false_fails() {
    let paper = paper();
    let claim = |id: &str| {
        paper
            .claims()
            .iter()
            .find(|claim| claim.id.to_string() == id)
            .unwrap_or_else(|| panic!("{id} is missing"))
    };
    let fails = |id: &str, statement: &str| {
        let established = paper.establish_as(claim(id), statement);
        assert_eq!(established.outcome, Outcome::Failed, "{statement}");
        established.detail
    };
    // All relations here are false.
    assert!(fails("field.e1", "f1 = x^2").contains("on the left"));
    fails("field.e1", "f1 = -x^2 + eps*x");
    fails("field.e1", "f1 != -x^2");
    fails("table1.e8.H", "exp(x + y) = exp(x)*exp(2*y)");
    fails("table1.e8.H", "gamma(x + 1) = gamma(x)");
    // Approximate values are checked to the last digit.
    fails("table1.e8.H", "sqrt(2) ~ 1.416");
    // All statements here are vacuous or malformed.
    assert!(fails("field.e1", "u := 1").contains("says nothing"));
    assert!(fails("field.e1", "f1 + = 1").contains("operand"));
    assert!(fails("field.e1", "f1 - frobnicate(x) = f1").contains("frobnicate"));
    assert!(fails("field.e1", "u := u + 1; u = 1").contains("uses itself"));
    assert!(fails("field.e1", "1/(x - x) = 1").contains("divides by zero"));
}

#[test]
fn mutations_change_one_number_or_one_sign() {
    assert_eq!(mutations("x = 19*y"), ["x = 20*y", "x = 2* 19*y", "x = 19/y"]);
    assert_eq!(mutations("h ~ 9.99"), ["h ~ 10.00", "h ~ 2* 9.99"]);
    assert_eq!(mutations("a := -b; a != b"), ["a := b; a != b", "a := 2* -b; a != b"]);
}
