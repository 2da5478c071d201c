//! The tables of the paper come out of densities and integrals exactly, and the prover agrees in
//! any dimension.

use kahan_algebra::rational_function::RationalFunction;
use kahan_algebra::system::System;
use kahan_algebra::{lexer, read};

use super::construct::invariant_tensor;
use super::*;
use crate::testing::{claim, function, functions};

/// The block of a source file of the catalog.
fn block(file: &'static str) -> &'static str {
    let (_, rest) = file.split_once("\nkahan! {\n").expect("the file has a block");
    rest.split_once("\n}\n").expect("the block ends").0
}

/// E1 to E6 in order: the blocks, whose P and Q are Table 3 and Table 4 divided by c.
const TABLES: [&str; 6] = [
    include_str!("../../../systems/src/catalog/e1.rs"),
    include_str!("../../../systems/src/catalog/e2.rs"),
    include_str!("../../../systems/src/catalog/e3.rs"),
    include_str!("../../../systems/src/catalog/e4.rs"),
    include_str!("../../../systems/src/catalog/e5.rs"),
    include_str!("../../../systems/src/catalog/e6.rs"),
];

fn system(text: &str) -> System {
    let reading = read(&lexer::lex(text).tokens);
    assert!(reading.diagnostics.is_empty(), "{:?}", reading.diagnostics);
    reading.system
}

fn bracket(
    system: &System,
    density: &RationalFunction,
    integrals: &[RationalFunction],
) -> Option<Vec<RationalFunction>> {
    let mut budget = Budget::new(MOST_TERMS, MOST_WORK);
    invariant_tensor(&system.field.symbols, density, integrals, &mut budget)
}

#[test]
fn the_brackets_of_tables_3_and_4_come_out_of_densities_and_integrals() {
    for file in TABLES {
        let system = system(block(file));
        let [h, k, rho] = ["H", "K", "rho"].map(|name| function(claim(&system, name)));
        let [p, q] = ["P", "Q"].map(|name| functions(claim(&system, name)));
        // ρ ĤK̂ with ρ = c/(HK): formulas (p1) and (q3).
        let density = &(&rho * &h) * &k;
        assert_eq!(
            bracket(&system, &-&density, std::slice::from_ref(&h)).as_ref(),
            Some(&p),
            "P of {}",
            system.name()
        );
        assert_eq!(bracket(&system, &density, &[k]).as_ref(), Some(&q), "Q/c of {}", system.name());
        // The other sign is another bracket: the comparison could have failed.
        assert_ne!(bracket(&system, &density, &[h]), Some(p));
    }
}

#[test]
fn in_the_plane_the_bracket_is_the_reciprocal_of_the_density() {
    let system = system(block(include_str!("../../../systems/src/catalog/lotka_volterra.rs")));
    let expected = functions(claim(&system, "P"));
    assert_eq!(bracket(&system, &function(claim(&system, "rho")), &[]), Some(expected));
}

#[test]
fn integrals_that_follow_from_one_another_have_no_bracket() {
    let system = system(E1_IN_FOUR);
    let [h, rho] = ["H", "rho"].map(|name| function(claim(&system, name)));
    assert_eq!(bracket(&system, &rho, &[h.clone(), &h * &h]), None);
    assert_eq!(bracket(&system, &RationalFunction::zero(), &[h.clone(), h]), None);
}

/// E1 with further components that follow y, each with the integral quotient by x.
const E1_IN_FOUR: &str = "xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z; wdot = -x*w;
    integral H = y/x; integral K = (x*z + y^2)/(1 - eps^2*x^2); integral L = w/x;
    density rho = 1/(x^2*y*(x*z + y^2));";
const E1_IN_FIVE: &str = "xdot = -x^2; ydot = -x*y; zdot = 2*y^2 + x*z; wdot = -x*w; vdot = -x*v;
    integral H = y/x; integral K = (x*z + y^2)/(1 - eps^2*x^2); integral L = w/x; integral M = (v + w)/x;
    density rho = 1/(x^3*y*(x*z + y^2));";

#[test]
fn brackets_in_dimensions_4_and_5_are_proved() {
    let oscillators = "xdot = y; ydot = -x; udot = a*v; vdot = -a*u;
        integral E = x^2 + y^2; integral F = u^2 + v^2; density one = 1;";
    let cases: [(&str, &str, &[&str]); 5] = [
        (oscillators, "one", &["E", "F"]),
        (E1_IN_FOUR, "rho", &["H", "K"]),
        (E1_IN_FOUR, "rho", &["K", "L"]),
        (E1_IN_FIVE, "rho", &["H", "K", "L"]),
        (E1_IN_FIVE, "rho", &["M", "K", "L"]),
    ];
    for (field, density, integrals) in cases {
        let system = system(field);
        let integrals: Vec<RationalFunction> =
            integrals.iter().map(|name| function(claim(&system, name))).collect();
        let density = function(claim(&system, density));
        let tensor = bracket(&system, &density, &integrals).expect("independent integrals");
        let claims = Claims::new(&system, &[], None);
        let entries = claims.bracket_entries(&system.field.symbols, &tensor);
        assert!(claims.bracket(1, &entries).is_some(), "{entries}");
    }
    // The density of another map makes a bracket that is refuted.
    let system = system(E1_IN_FOUR);
    let casimirs = ["H", "K"].map(|name| function(claim(&system, name)));
    let wrong = bracket(&system, &RationalFunction::one(), &casimirs).expect("independent integrals");
    let claims = Claims::new(&system, &[], None);
    assert_eq!(claims.bracket(1, &claims.bracket_entries(&system.field.symbols, &wrong)), None);
}
